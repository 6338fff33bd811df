#include "app/keys.h"

#include "base/nearest_name.h"
#include "base/words.h"

#include <algorithm>
#include <cstddef>

namespace slicecast {

namespace {

constexpr std::uint8_t kNone = kActions;

constexpr std::size_t index(Action action) {
    return static_cast<std::size_t>(action);
}

std::uint8_t numberOf(Action action) {
    return static_cast<std::uint8_t>(action);
}

// Removes the text up to a separator, and the separator; returns that text.
std::string_view takePart(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

std::string unknownKey(std::string_view code) {
    return words("Unknown key '", code, "'.", didYouMean(code, keyCodes()));
}

std::string unknownAction(std::string_view name) {
    return words("Unknown action '", name, "'.", didYouMean(name, actionNames()));
}

}  // namespace

void KeyBindings::reset() {
    actions_.fill(kNone);
    for (int i = 0; i < kActions; ++i) {
        for (std::string_view codes = infoOf(static_cast<Action>(i)).codes; !codes.empty();)
            set(*findPosition(takePart(codes, ' ')), static_cast<Action>(i));
    }
}

void KeyBindings::set(const KeyPosition& position, Action action) {
    actions_[static_cast<std::size_t>(position.scancode)] = numberOf(action);
}

std::string KeyBindings::bind(std::string_view code, std::string_view action) {
    const KeyPosition* position = findPosition(code);
    const std::optional<Action> found = findAction(action);
    if (position == nullptr) return unknownKey(code);
    if (!found) return unknownAction(action);
    if (position->scancode == SDL_SCANCODE_ESCAPE && found != Action::leave)
        return "Escape always leaves the picture. It cannot do anything else.";
    set(*position, *found);
    return {};
}

std::string KeyBindings::unbind(std::string_view code) {
    const KeyPosition* position = findPosition(code);
    if (position == nullptr) return unknownKey(code);
    if (position->scancode == SDL_SCANCODE_ESCAPE)
        return "Escape always leaves the picture. It cannot be unbound.";
    actions_[static_cast<std::size_t>(position->scancode)] = kNone;
    return {};
}

std::string KeyBindings::read(std::string_view text) {
    // First all named actions lose their keys, so that two actions can swap theirs
    KeyBindings next = *this;
    for (std::string_view rest = text; !rest.empty();) {
        std::string_view part = takePart(rest, ',');
        if (part.find('=') == std::string_view::npos)
            return words("Expected ACTION=KEY, such as forward=ArrowUp, not '", part, "'.");
        const std::string_view name = takePart(part, '=');
        const std::optional<Action> action = findAction(name);
        if (!action) return unknownAction(name);
        if (action != Action::leave)
            std::replace(next.actions_.begin(), next.actions_.end(), numberOf(*action), kNone);
    }
    for (std::string_view rest = text; !rest.empty();) {
        std::string_view codes = takePart(rest, ',');
        const std::string_view name = takePart(codes, '=');
        do {
            std::string fault = next.bind(takePart(codes, '+'), name);
            if (!fault.empty()) return fault;
        } while (!codes.empty());
    }
    *this = next;
    return {};
}

std::optional<Action> KeyBindings::actionOf(SDL_Scancode scancode) const {
    const std::size_t at = static_cast<std::size_t>(scancode);
    if (at >= actions_.size() || actions_[at] == kNone) return std::nullopt;
    return static_cast<Action>(actions_[at]);
}

const KeyPosition* KeyBindings::keyOf(Action action, int number) const {
    for (const KeyPosition& position : allPositions()) {
        if (actionOf(position.scancode) == action && number-- == 0) return &position;
    }
    return nullptr;
}

// Whether these actions have their standard keys, and no others.
bool KeyBindings::isStandard(Action first, Action last) const {
    const KeyBindings standard;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        const auto isOne = [&](std::uint8_t action) {
            return action >= numberOf(first) && action <= numberOf(last);
        };
        const bool same = actions_[i] == standard.actions_[i];
        if (!same && (isOne(actions_[i]) || isOne(standard.actions_[i]))) return false;
    }
    return true;
}

// The first key of each of the line's actions, then the second of each, and so on; no label twice.
std::vector<std::string_view> KeyBindings::labels(Action first, Action last) const {
    if (const char* together = infoOf(first).lineKeys;
        together != nullptr && isStandard(first, last))
        return {together};
    std::vector<std::string_view> labels;
    bool more = true;
    for (int number = 0; more; ++number) {
        more = false;
        for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i) {
            const KeyPosition* key = keyOf(static_cast<Action>(i), number);
            if (key == nullptr) continue;
            more = true;
            if (std::find(labels.begin(), labels.end(), key->label) == labels.end())
                labels.emplace_back(key->label);
        }
    }
    return labels;
}

std::vector<KeyHelp> KeyBindings::help() const {
    std::vector<KeyHelp> lines;
    for (int i = 0; i < kActions; ++i) {
        const ActionInfo& info = infoOf(static_cast<Action>(i));
        if (info.line == nullptr) continue;
        int last = i;
        while (last + 1 < kActions && infoOf(static_cast<Action>(last + 1)).line == nullptr) ++last;
        lines.push_back({labels(static_cast<Action>(i), static_cast<Action>(last)),
                         *info.line == '\0' ? info.does : info.line, static_cast<Action>(i),
                         static_cast<Action>(last)});
    }
    return lines;
}

std::string keysText(const KeyHelp& line) {
    std::string text;
    for (const std::string_view key : line.keys) add(text, {text.empty() ? "" : " ", key});
    return text;
}

void HeldKeys::press(SDL_Scancode scancode, Action action) {
    std::uint8_t& down = down_[static_cast<std::size_t>(scancode)];
    if (down != 0 || infoOf(action).press != Press::hold) return;
    down = static_cast<std::uint8_t>(numberOf(action) + 1);
    ++count_[index(action)];
    pressed_[index(action)] = true;
}

void HeldKeys::release(SDL_Scancode scancode) {
    std::uint8_t& down = down_[static_cast<std::size_t>(scancode)];
    if (down == 0) return;
    --count_[static_cast<std::size_t>(down - 1)];
    down = 0;
}

void HeldKeys::releaseAll() {
    *this = HeldKeys();
}

bool HeldKeys::isDown(Action action) const {
    return count_[index(action)] > 0;
}

Input HeldKeys::takeInput() {
    const auto active = [this](Action action) {
        return count_[index(action)] > 0 || pressed_[index(action)];
    };
    const auto axis = [active](Action positive, Action negative) {
        return (active(positive) ? 1.0 : 0.0) - (active(negative) ? 1.0 : 0.0);
    };
    Input input;
    input.forward = axis(Action::forward, Action::back);
    input.strafe = axis(Action::strafeRight, Action::strafeLeft);
    input.turn = axis(Action::turnRight, Action::turnLeft);
    input.look = axis(Action::lookUp, Action::lookDown);
    input.fly = axis(Action::rise, Action::sink);
    input.jump = active(Action::jump);
    input.fast = active(Action::fast);
    input.slow = active(Action::slow);
    input.use = active(Action::use);
    input.open = active(Action::open);
    input.close = active(Action::close);
    pressed_ = {};
    return input;
}

}  // namespace slicecast
