#include "scene/checker.h"
#include "base/later_text.h"

#include "base/sort.h"
#include "scene/limits.h"
#include "scene/spares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicecast {
namespace {

// The value of a hexadecimal digit, or nothing.
std::optional<int> hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return std::nullopt;
}

}  // namespace

Fault moreFaults(const std::string& file, std::size_t count) {
    Fault last;
    last.file = file;
    last.found = words(Counted{static_cast<std::int64_t>(count), "more fault"});
    last.expected = words("none; only the first ", kMaxFaults, " are listed");
    return last;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t kMostBytes = 60;
    std::string shown = "\"";
    std::size_t offset = 0;
    while (offset < text.size() && offset < kMostBytes) {
        const char32_t c = takeCodePoint(text, offset);
        if (c == '"' || c == '\\') shown += '\\';
        // Control characters would break the line that the message stands on.
        shown += c < 0x20 || (c >= 0x7f && c < 0xa0) ? std::string("?") : toUtf8(c);
    }
    return shown + (offset < text.size() ? "...\"" : "\"");
}

std::string listed(const std::vector<std::string_view>& texts) {
    std::string list;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (i > 0) list += i + 1 < texts.size() ? ", " : " or ";
        list += quoted(texts[i]);
    }
    return list;
}

bool Checker::onlyCounts() {
    if (faults_.size() < kMaxFaults) return false;
    ++omitted_;
    return true;
}

void Checker::addAt(std::vector<Placed>& list, std::size_t offset, const JsonValue* at, int row,
                    int character, const Words& found, const Words& expected) {
    if (&list == &faults_ ? onlyCounts() : list.size() >= kMaxFaults) return;
    const TextPosition place = source_.place(offset);
    Placed& added = list.emplace_back();
    added.offset = offset;
    added.number = faults_.size() + warnings_.size();
    added.fault = {file_,       at != nullptr ? at->pointer() : std::string(),
                   place.line,  place.column,
                   row,         character,
                   found.str(), expected.str()};
}

void Checker::warn(JsonValue at, const Words& found, const Words& expected) {
    addAt(warnings_, at.offset(), &at, -1, -1, found, expected);
}

Fault Checker::faultAt(JsonValue at, const Words& found, const Words& expected) const {
    const TextPosition place = source_.place(at.offset());
    return {file_, at.pointer(), place.line, place.column, -1, -1, found.str(), expected.str()};
}

void Checker::add(JsonValue at, const Words& found, const Words& expected) {
    addAt(faults_, at.offset(), &at, -1, -1, found, expected);
}

void Checker::addAtKey(JsonValue member, const Words& found, const Words& expected) {
    addAt(faults_, member.keyOffset(), &member, -1, -1, found, expected);
}

void Checker::add(JsonValue at, const char* found, const char* expected) {
    add(at, Words(found), Words(expected));
}

void Checker::add(JsonValue at, const Words& found, const char* expected) {
    add(at, found, Words(expected));
}

void Checker::addAtKey(JsonValue member, const char* found, const char* expected) {
    addAtKey(member, Words(found), Words(expected));
}

void Checker::refuse(JsonValue value, const char* expected) {
    refuse(value, Words(expected));
}

void Checker::warn(JsonValue at, const char* found, const char* expected) {
    warn(at, Words(found), Words(expected));
}

void Checker::addSecondKey(JsonValue again, JsonValue first) {
    if (onlyCounts()) return;
    const TextPosition place = source_.place(first.keyOffset());
    addAtKey(again, {"the key ", quoted(again.key()), " a second time"},
             {"each key once; the first is at line "_later, place.line, ", column ", place.column});
}

void Checker::refuse(JsonValue value, const Words& expected) {
    add(value, shown(value), expected);
}

void Checker::addInRow(JsonValue text, int row, int character, const Words& found,
                       const Words& expected) {
    if (onlyCounts()) return;
    // Of the signs before it, some may be several characters.
    std::size_t offset = 0;
    for (int x = 0; x < character; ++x) takeSign(text.text(), offset);
    const auto before = static_cast<int>(countCharacters(text.text().substr(0, offset)));
    addAt(faults_, source_.characterOffset(text.offset(), before), &text, row, character, found,
          expected);
}

void Checker::addSyntax(const SyntaxFault& fault) {
    addAt(faults_, fault.offset, nullptr, -1, -1, fault.found, fault.expected);
}

std::vector<Fault> Checker::inOrder(std::vector<Placed> list) {
    mergeSort(list, [](const Placed& a, const Placed& b) {
        return a.offset != b.offset ? a.offset < b.offset : a.number < b.number;
    });
    std::vector<Fault> faults;
    faults.reserve(list.size());
    for (Placed& entry : list) faults.push_back(std::move(entry.fault));
    return faults;
}

std::vector<Fault> Checker::take() {
    std::vector<Fault> faults = inOrder(std::exchange(faults_, {}));
    if (omitted_ > 0) faults.push_back(moreFaults(file_, omitted_));
    omitted_ = 0;
    return faults;
}

std::vector<Fault> Checker::takeWarnings() {
    return inOrder(std::exchange(warnings_, {}));
}

std::string Checker::shown(JsonValue value) const {
    switch (value.kind()) {
        case JsonValue::Kind::null:
            return "null";
        case JsonValue::Kind::boolean:
            return value.boolean() ? "true" : "false";
        case JsonValue::Kind::number: {
            // As it was typed.
            const std::string_view rest = source_.text().substr(value.offset(), 30);
            const std::size_t end =
                std::min(rest.find_first_not_of("0123456789+-.eE"), rest.size());
            return words("the number ", rest.substr(0, end));
        }
        case JsonValue::Kind::text:
            return words("the text ", quoted(value.text()));
        case JsonValue::Kind::array:
            return value.count() == 0
                       ? "an empty array"
                       : words("an array of ",
                               Counted{static_cast<std::int64_t>(value.count()), "element"});
        case JsonValue::Kind::object:
            return "an object";
    }
    return {};
}

__attribute__((noinline)) void Checker::addUnknownKey(JsonValue member,
                                                      std::span<const std::string_view> known,
                                                      Fields& fields) {
    if (onlyCounts()) return;
    const std::vector<std::string_view> keys(known.begin(), known.end());
    addAtKey(member, {"the unknown key ", quoted(member.key())},
             {"one of the keys ", listed(keys), suggestion(member.key(), keys)});
    const std::string_view meant = nearestName(member.key(), keys);
    if (!meant.empty()) fields.addMisspelt(meant, member);
}

std::optional<Fields> Checker::fields(JsonValue value, std::span<const std::string_view> known,
                                      LaterText expected) {
    if (!value.isObject()) {
        refuse(value, wordsOf(expected));
        return std::nullopt;
    }
    Fields fields(*this, value);
    for (const JsonValue member : value) {
        if (member.key() == "comment") {
            if (!member.isText()) refuse(member, "a text");
        } else if (member.key() == "data" ||
                   std::find(known.begin(), known.end(), member.key()) != known.end()) {
            continue;
        } else {
            addUnknownKey(member, known, fields);
        }
    }
    return fields;
}

std::optional<double> Checker::number(JsonValue value, const NumberRange& range) {
    if (value.kind() == JsonValue::Kind::number) {
        const double v = value.number();
        if ((range.aboveLow ? v > range.low : v >= range.low) && v <= range.high) return v;
    }
    refuse(value, range.words);
    return std::nullopt;
}

std::optional<int> Checker::wholeNumber(JsonValue value, const NumberRange& range) {
    const std::optional<double> v = number(value, range);
    if (!v) return std::nullopt;
    if (*v == std::floor(*v)) return static_cast<int>(*v);
    refuse(value, range.words);
    return std::nullopt;
}

std::optional<bool> Checker::flag(JsonValue value) {
    if (value.kind() == JsonValue::Kind::boolean) return value.boolean();
    refuse(value, "true or false");
    return std::nullopt;
}

std::optional<std::string> Checker::text(JsonValue value, std::size_t longest,
                                         const Words& expected) {
    if (value.isText()) {
        const std::size_t length = countCharacters(value.text());
        if (length >= 1 && length <= longest) return std::string(value.text());
        if (length > longest) {
            add(value, {"a text of ", length, " characters"},
                words(expected.str(), " of at most ", longest));
            return std::nullopt;
        }
    }
    refuse(value, expected);
    return std::nullopt;
}

// No first picture needs it.
__attribute__((noinline)) std::optional<std::uint16_t> Checker::nameElsewhere(
    JsonValue value, const NameTable& names, const char* what) {
    std::optional<std::uint16_t> id;
    if (uses_ != nullptr) {
        id = names.find(value.text());
        uses_->note(names, value.text());
    }
    if (!id && names.more() != nullptr) id = names.more()->bring(value);
    if (!id && !onlyCounts()) {
        add(value, {"the name ", quoted(value.text())},
            {"the name of a ", what, names.suggestionFor(value.text())});
    }
    return id;
}

std::optional<std::uint16_t> Checker::name(JsonValue value, const NameTable& names,
                                           const char* what) {
    const std::optional<std::string> name = text(value, kMaxNameLength, {"the name of a ", what});
    if (!name) return std::nullopt;
    const std::optional<std::uint16_t> id = names.find(*name);
    if (id && uses_ == nullptr) return id;
    if (!id && names.awaitsMore()) {
        ++awaiting_;
        return std::nullopt;
    }
    return nameElsewhere(value, names, what);
}

void Checker::checkName(JsonValue member) {
    if (member.key().empty() || countCharacters(member.key()) > kMaxNameLength)
        addAtKey(member, {"the name ", quoted(member.key())},
                 {"a name of 1 to ", kMaxNameLength, " characters"});
}

std::optional<Colour> Checker::colour(JsonValue value) {
    const std::string_view text = value.isText() ? value.text() : std::string_view();
    std::uint8_t channels[3] = {};
    bool isSound = text.size() == 7 && text[0] == '#';
    for (std::size_t i = 0; isSound && i < 3; ++i) {
        const std::optional<int> high = hexDigit(text[1 + 2 * i]);
        const std::optional<int> low = hexDigit(text[2 + 2 * i]);
        isSound = high && low;
        if (isSound) channels[i] = static_cast<std::uint8_t>(*high * 16 + *low);
    }
    if (isSound) return Colour{channels[0], channels[1], channels[2], 255};
    refuse(value,
           "a colour as \"#rrggbb\", with two hexadecimal digits each for red, green and blue");
    return std::nullopt;
}

FoundValue Fields::find(const char* key) const {
    if (const FoundValue member = object_.find(key)) return member;
    for (const auto& [meant, member] : misspelt_) {
        if (meant == key) return member;
    }
    return {};
}

FoundValue Fields::require(const char* key, const char* expected) const {
    const FoundValue member = find(key);
    if (!member) checker_->add(object_, {"no key ", quoted(key)}, {quoted(key), ", ", expected});
    return member;
}

double Fields::number(const char* key, const NumberRange& range, double fallback) const {
    const FoundValue member = find(key);
    return member ? checker_->number(*member, range).value_or(fallback) : fallback;
}

int Fields::wholeNumber(const char* key, const NumberRange& range, int fallback) const {
    const FoundValue member = find(key);
    return member ? checker_->wholeNumber(*member, range).value_or(fallback) : fallback;
}

bool Fields::flag(const char* key, bool fallback) const {
    const FoundValue member = find(key);
    return member ? checker_->flag(*member).value_or(fallback) : fallback;
}

Colour Fields::colour(const char* key, Colour fallback) const {
    const FoundValue member = find(key);
    return member ? checker_->colour(*member).value_or(fallback) : fallback;
}

std::optional<std::uint16_t> Fields::mapOr(const NameTable& maps, int fallback) const {
    const FoundValue member = find("map");
    if (member) return checker_->name(*member, maps, "map");
    return static_cast<std::uint16_t>(fallback);
}

}  // namespace slicecast
