#include "app/keys.h"

#include "session/options.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace slicecast {
namespace {

// What a key does in the beginning.
Action standard(SDL_Scancode scancode) {
    return *KeyBindings().actionOf(scancode);
}

// The keys of an action, by their codes.
std::string keysOf(const KeyBindings& keys, Action action) {
    std::string codes;
    for (int i = 0; const KeyPosition* key = keys.keyOf(action, i); ++i)
        codes += std::string(key->code) + ' ';
    return codes;
}

class Hands : public ::testing::Test {
protected:
    void press(SDL_Scancode scancode) { held.press(scancode, standard(scancode)); }
    HeldKeys held;
};

TEST(Keyboard, EachPositionOccursOnce) {
    std::set<SDL_Scancode> scancodes;
    std::set<std::string_view> codes;
    for (const KeyPosition& key : allPositions()) {
        EXPECT_TRUE(scancodes.insert(key.scancode).second) << key.code;
        EXPECT_TRUE(codes.insert(key.code).second) << key.code;
        EXPECT_EQ(findPosition(key.code), &key);
        EXPECT_NE(std::string_view(key.label), "") << key.code;
    }
    for (const char* code : {"Tab", "", "F13", "keyW"}) EXPECT_EQ(findPosition(code), nullptr);
}

// A letter's code in a page is "Key" and the letter of the American layout, by which SDL names its
// scancodes.
TEST(Keyboard, CodesAndScancodesAreTheSamePlaces) {
    for (const KeyPosition& key : allPositions()) {
        const std::string_view code = key.code;
        if (code.starts_with("Key")) {
            EXPECT_EQ(key.scancode, SDL_SCANCODE_A + (code[3] - 'A')) << code;
        }
        if (code.size() == 7 && code.starts_with("Numpad") && code[6] != '0') {
            EXPECT_EQ(key.scancode, SDL_SCANCODE_KP_1 + (code[6] - '1')) << code;
        }
    }
}

TEST(Actions, NamesAndStandardKeysAreUnique) {
    std::set<std::string_view> names;
    const KeyBindings keys;
    for (int i = 0; i < kActions; ++i) {
        const Action action = static_cast<Action>(i);
        const ActionInfo& info = infoOf(action);
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_NE(std::string_view(info.does), "") << info.name;
        if (action == Action::mouse) continue;
        EXPECT_EQ(findAction(info.name), action);
        EXPECT_EQ(keysOf(keys, action), std::string(info.codes) + ' ') << info.name;
    }
    EXPECT_FALSE(findAction(""));
    EXPECT_FALSE(findAction("fowards"));
    EXPECT_EQ(findAction("forward"), Action::forward);
    EXPECT_EQ(findAction("leave"), Action::leave);
    EXPECT_EQ(findAction("map7"), Action::map7);
}

TEST(Actions, OptionsOfActionsExist) {
    for (const ActionInfo& info : allActions()) {
        if (info.option == nullptr) continue;
        const OptionInfo* option = findOption(info.option);
        ASSERT_NE(option, nullptr) << info.name;
        const bool isNumber =
            option->kind != OptionKind::onOff && option->kind != OptionKind::choice;
        EXPECT_EQ(info.by != 0.0, isNumber) << info.name;
    }
}

// Seen on the pad, east is to the right and south below.
TEST(Actions, TheNumberPadIsACompass) {
    EXPECT_EQ(standard(SDL_SCANCODE_KP_6), Action::faceEast);
    EXPECT_EQ(standard(SDL_SCANCODE_KP_2), Action::faceSouth);
    EXPECT_EQ(standard(SDL_SCANCODE_KP_1), Action::faceSouthWest);
    EXPECT_EQ(standard(SDL_SCANCODE_KP_4), Action::faceWest);
    EXPECT_EQ(standard(SDL_SCANCODE_KP_8), Action::faceNorth);
    EXPECT_EQ(standard(SDL_SCANCODE_KP_9), Action::faceNorthEast);
}

TEST(KeyBindings, BindsAKeyToAnotherAction) {
    KeyBindings keys;
    EXPECT_EQ(keys.bind("ArrowUp", "forward"), "");
    EXPECT_EQ(keysOf(keys, Action::forward), "KeyW ArrowUp ");
    EXPECT_EQ(keysOf(keys, Action::lookUp), "");
    EXPECT_EQ(keys.unbind("KeyW"), "");
    EXPECT_EQ(keysOf(keys, Action::forward), "ArrowUp ");
    EXPECT_FALSE(keys.actionOf(SDL_SCANCODE_W));
    keys.reset();
    EXPECT_EQ(keysOf(keys, Action::forward), "KeyW ");
    EXPECT_EQ(keysOf(keys, Action::lookUp), "ArrowUp ");
}

TEST(KeyBindings, ReadsBindingsFromText) {
    KeyBindings keys;
    EXPECT_EQ(keys.read("forward=KeyS+ArrowUp,back=KeyW"), "") << "two that swap theirs";
    EXPECT_EQ(keysOf(keys, Action::forward), "KeyS ArrowUp ");
    EXPECT_EQ(keysOf(keys, Action::back), "KeyW ");
    EXPECT_EQ(keys.read("leave=KeyZ"), "");
    EXPECT_EQ(keysOf(keys, Action::leave), "KeyZ Escape ") << "Escape always leaves";
}

TEST(KeyBindings, FaultyTextsAreReportedAndChangeNothing) {
    KeyBindings keys;
    const std::pair<const char*, const char*> faults[] = {
        {"foward=KeyZ", "Unknown action 'foward'. Did you mean 'forward'?"},
        {"forward=Keyz", "Unknown key 'Keyz'. Did you mean 'KeyZ'?"},
        {"forward=Tab", "Unknown key 'Tab'."},
        {"forward", "Expected ACTION=KEY, such as forward=ArrowUp, not 'forward'."},
        {"forward=KeyZ,back=", "Unknown key ''."},
        {"=KeyZ", "Unknown action ''."},
        {"forward=Escape", "Escape always leaves the picture. It cannot do anything else."}};
    for (const auto& [text, fault] : faults) EXPECT_EQ(keys.read(text), fault);
    EXPECT_EQ(keys.unbind("Escape"), "Escape always leaves the picture. It cannot be unbound.");
    EXPECT_EQ(keysOf(keys, Action::forward), "KeyW ");
    EXPECT_EQ(keys.actionOf(SDL_SCANCODE_ESCAPE), Action::leave);
}

TEST(KeyHelp, FollowsTheKeys) {
    KeyBindings keys;
    const auto line = [&](Action first) {
        for (const KeyHelp& one : keys.help()) {
            if (one.first == first) return keysText(one) + ": " + std::string(one.does);
        }
        return std::string();
    };
    EXPECT_EQ(line(Action::forward), "W S: walk ahead and back");
    EXPECT_EQ(line(Action::strafeLeft), "A D Q E: step left and right");
    EXPECT_EQ(line(Action::fast), "Shift Ctrl: faster, slower");
    EXPECT_EQ(line(Action::turnLeft), "Arrows: turn, look up and down");
    EXPECT_EQ(line(Action::mouse), "Click: look with the mouse");
    EXPECT_EQ(line(Action::map0), "0-9: go to another map of the scene");
    EXPECT_EQ(keys.read("lookUp=KeyZ,back="), "Unknown key ''.");
    EXPECT_EQ(keys.read("lookUp=KeyZ"), "");
    EXPECT_EQ(line(Action::turnLeft), "Left Right Z Down: turn, look up and down");
    EXPECT_EQ(keys.unbind("KeyX"), "");
    EXPECT_EQ(line(Action::use), ": open or close the gates nearby");
}

// The documentation has the table of the standard keys.
TEST(KeyHelp, EqualsTheDocumentation) {
    std::ifstream file(SLICECAST_PLAY_PAGE);
    ASSERT_TRUE(file);
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    std::string table = "| keys | what they do |\n| --- | --- |\n";
    for (const KeyHelp& line : KeyBindings().help()) {
        std::string keys;
        for (const std::string_view key : line.keys)
            keys += (keys.empty() ? "`" : " `") + std::string(key) + '`';
        table += "| " + keys + " | " + std::string(line.does) + " |\n";
    }
    EXPECT_NE(page.find(table), std::string::npos) << "expected in web/docs/play.md:\n" << table;
}

TEST_F(Hands, GatesHaveThree) {
    press(SDL_SCANCODE_X);
    EXPECT_TRUE(held.takeInput().use);
    held.release(SDL_SCANCODE_X);
    EXPECT_FALSE(held.takeInput().use);
    press(SDL_SCANCODE_PERIOD);
    EXPECT_TRUE(held.takeInput().open);
    press(SDL_SCANCODE_COMMA);
    EXPECT_TRUE(held.takeInput().close);
}

TEST_F(Hands, BecomeAxes) {
    for (const SDL_Scancode code : {SDL_SCANCODE_S, SDL_SCANCODE_D, SDL_SCANCODE_LEFT,
                                    SDL_SCANCODE_UP, SDL_SCANCODE_PAGEDOWN, SDL_SCANCODE_LSHIFT}) {
        press(code);
    }
    const Input input = held.takeInput();
    EXPECT_EQ(input.forward, -1.0);
    EXPECT_EQ(input.strafe, 1.0);
    EXPECT_EQ(input.turn, -1.0);
    EXPECT_EQ(input.look, 1.0);
    EXPECT_EQ(input.fly, -1.0);
    EXPECT_TRUE(input.fast);
    EXPECT_FALSE(input.slow);
    EXPECT_FALSE(input.jump);
}

TEST_F(Hands, OppositeKeysCancel) {
    press(SDL_SCANCODE_W);
    press(SDL_SCANCODE_S);
    EXPECT_EQ(held.takeInput().forward, 0.0);
    held.release(SDL_SCANCODE_S);
    EXPECT_EQ(held.takeInput().forward, 1.0);
}

TEST_F(Hands, AnActionLastsUntilBothOfItsKeysAreUp) {
    press(SDL_SCANCODE_A);
    press(SDL_SCANCODE_Q);
    held.takeInput();
    held.release(SDL_SCANCODE_A);
    EXPECT_EQ(held.takeInput().strafe, -1.0);
    held.release(SDL_SCANCODE_Q);
    EXPECT_EQ(held.takeInput().strafe, 0.0);
}

TEST_F(Hands, APressShorterThanAStepCountsForOne) {
    press(SDL_SCANCODE_SPACE);
    held.release(SDL_SCANCODE_SPACE);
    EXPECT_TRUE(held.takeInput().jump);
    EXPECT_FALSE(held.takeInput().jump);
}

TEST_F(Hands, RepeatedPressesAndStrayReleasesChangeNothing) {
    held.release(SDL_SCANCODE_W);
    press(SDL_SCANCODE_W);
    press(SDL_SCANCODE_W);
    held.takeInput();
    held.release(SDL_SCANCODE_W);
    EXPECT_EQ(held.takeInput().forward, 0.0);
    EXPECT_FALSE(held.isDown(Action::forward));
}

TEST_F(Hands, ReleaseAllReleasesEverything) {
    press(SDL_SCANCODE_W);
    press(SDL_SCANCODE_LCTRL);
    held.releaseAll();
    const Input input = held.takeInput();
    EXPECT_EQ(input.forward, 0.0);
    EXPECT_FALSE(input.slow);
}

}  // namespace
}  // namespace slicecast
