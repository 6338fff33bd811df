#include "app/keys.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace slicecast {
namespace {

const Key& key(SDL_Scancode scancode) {
    return *findKey(scancode);
}

TEST(Keys, EachPositionHasOneMeaning) {
    std::set<SDL_Scancode> scancodes;
    std::set<std::string_view> codes;
    for (const Key& k : allKeys()) {
        EXPECT_TRUE(scancodes.insert(k.scancode).second) << k.code;
        EXPECT_TRUE(codes.insert(k.code).second) << k.code;
        EXPECT_EQ(findKey(k.scancode), &k);
        EXPECT_EQ(findKeyByCode(k.code), &k);
    }
}

TEST(Keys, EveryActionHasAKey) {
    std::set<Action> actions;
    for (const Key& k : allKeys()) actions.insert(k.action);
    EXPECT_EQ(actions.size(), static_cast<std::size_t>(Action::fasterSlices) + 1);
}

// A letter's code in a page is "Key" and the letter of the American layout, by which SDL names its
// scancodes.
TEST(Keys, CodesAndScancodesAreTheSamePlaces) {
    for (const Key& k : allKeys()) {
        if (k.code.size() == 4 && k.code.substr(0, 3) == "Key") {
            EXPECT_EQ(k.scancode, SDL_SCANCODE_A + (k.code[3] - 'A')) << k.code;
        }
        if (k.code.size() == 7 && k.code.substr(0, 6) == "Numpad") {
            EXPECT_EQ(k.scancode, SDL_SCANCODE_KP_1 + (k.code[6] - '1')) << k.code;
        }
    }
}

TEST(Keys, GatesHaveThree) {
    HeldKeys held;
    held.press(key(SDL_SCANCODE_X));
    EXPECT_TRUE(held.takeInput().use);
    held.release(key(SDL_SCANCODE_X));
    EXPECT_FALSE(held.takeInput().use);
    held.press(key(SDL_SCANCODE_PERIOD));
    EXPECT_TRUE(held.takeInput().open);
    held.press(key(SDL_SCANCODE_COMMA));
    EXPECT_TRUE(held.takeInput().close);
}

TEST(Keys, UnknownKeysMeanNothing) {
    EXPECT_EQ(findKey(SDL_SCANCODE_TAB), nullptr);
    EXPECT_EQ(findKeyByCode("Tab"), nullptr);
    EXPECT_EQ(findKeyByCode(""), nullptr);
    EXPECT_EQ(findKeyByCode("F5"), nullptr);
}

// Seen on the pad, east is to the right and south below.
TEST(Keys, TheNumberPadIsACompass) {
    EXPECT_EQ(key(SDL_SCANCODE_KP_6).headingDegrees, 0.0);
    EXPECT_EQ(key(SDL_SCANCODE_KP_3).headingDegrees, 45.0);
    EXPECT_EQ(key(SDL_SCANCODE_KP_2).headingDegrees, 90.0);
    EXPECT_EQ(key(SDL_SCANCODE_KP_1).headingDegrees, 135.0);
    EXPECT_EQ(key(SDL_SCANCODE_KP_4).headingDegrees, 180.0);
    EXPECT_EQ(key(SDL_SCANCODE_KP_7).headingDegrees, 225.0);
    EXPECT_EQ(key(SDL_SCANCODE_KP_8).headingDegrees, 270.0);
    EXPECT_EQ(key(SDL_SCANCODE_KP_9).headingDegrees, 315.0);
}

TEST(HeldKeys, BecomeAxes) {
    HeldKeys held;
    for (const SDL_Scancode code : {SDL_SCANCODE_S, SDL_SCANCODE_D, SDL_SCANCODE_LEFT,
                                    SDL_SCANCODE_UP, SDL_SCANCODE_PAGEDOWN, SDL_SCANCODE_LSHIFT}) {
        held.press(key(code));
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

TEST(HeldKeys, OppositeKeysCancel) {
    HeldKeys held;
    held.press(key(SDL_SCANCODE_W));
    held.press(key(SDL_SCANCODE_S));
    EXPECT_EQ(held.takeInput().forward, 0.0);
    held.release(key(SDL_SCANCODE_S));
    EXPECT_EQ(held.takeInput().forward, 1.0);
}

TEST(HeldKeys, AnActionLastsUntilBothOfItsKeysAreUp) {
    HeldKeys held;
    held.press(key(SDL_SCANCODE_A));
    held.press(key(SDL_SCANCODE_Q));
    held.takeInput();
    held.release(key(SDL_SCANCODE_A));
    EXPECT_EQ(held.takeInput().strafe, -1.0);
    held.release(key(SDL_SCANCODE_Q));
    EXPECT_EQ(held.takeInput().strafe, 0.0);
}

TEST(HeldKeys, APressShorterThanAStepCountsForOne) {
    HeldKeys held;
    held.press(key(SDL_SCANCODE_SPACE));
    held.release(key(SDL_SCANCODE_SPACE));
    EXPECT_TRUE(held.takeInput().jump);
    EXPECT_FALSE(held.takeInput().jump);
}

TEST(HeldKeys, RepeatedPressesAndStrayReleasesChangeNothing) {
    HeldKeys held;
    held.release(key(SDL_SCANCODE_W));
    held.press(key(SDL_SCANCODE_W));
    held.press(key(SDL_SCANCODE_W));
    held.takeInput();
    held.release(key(SDL_SCANCODE_W));
    EXPECT_EQ(held.takeInput().forward, 0.0);
    EXPECT_FALSE(held.isDown(Action::forward));
}

TEST(HeldKeys, ReleaseAllLeavesNothing) {
    HeldKeys held;
    held.press(key(SDL_SCANCODE_W));
    held.press(key(SDL_SCANCODE_LCTRL));
    held.releaseAll();
    const Input input = held.takeInput();
    EXPECT_EQ(input.forward, 0.0);
    EXPECT_FALSE(input.slow);
}

}  // namespace
}  // namespace slicecast
