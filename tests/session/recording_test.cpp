#include "session/recording_text.h"

#include "base/random.h"
#include "session/session.h"
#include "world_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A field; the player starts in its middle, with a block in the way to the east.
World makeField() {
    WorldBuilder make;
    make.world.title = "A field";
    make.texture("grey", {128, 128, 128, 255});
    make.block('#', {.name = "block"});
    make.map("field", 20, 20, 2);
    make.put('#', 14, 10);
    make.start(10.5, 10.5);
    return std::move(make.world);
}

Input anyInput(Random& random) {
    Input input;
    input.forward = random.between(-1.2, 1.2);
    input.strafe = random.between(-1.0, 1.0);
    input.turn = random.between(-1.0, 1.0);
    input.look = random.between(-1.0, 1.0);
    input.fly = random.between(-1.0, 1.0);
    input.turnDegrees = random.between(-3.0, 3.0);
    input.lookHeights = random.between(-0.02, 0.02);
    input.jump = random.oneIn(4);
    input.fast = random.oneIn(4);
    input.slow = random.oneIn(4);
    input.use = random.oneIn(5);
    input.open = random.oneIn(5);
    input.close = random.oneIn(5);
    return input;
}

// Plays a game with all inputs, and with all that a recording holds besides, except changes of
// cells. Returns the fingerprint after each step.
std::vector<std::uint64_t> playAnything(Session& session, Recorder& recorder, int steps) {
    Random random(7);
    std::vector<std::uint64_t> fingerprints;
    for (int i = 0; i < steps; ++i) {
        if (i == 50) session.setFlying(true);
        if (i == 120) session.setHeading(-33.34567);
        if (i == 150) session.levelLook();
        if (i == 200) session.setOption("speed", "2.5");
        if (i == 210) session.setOption("fov", "75");
        if (i == 260)
            session.setEye(
                {0, toCoordinate(3.3), toCoordinate(4.4), toCoordinate(1.1), 271.3, -0.123456789});
        if (i == 300) session.setFlying(false);
        if (i == 350) recorder.mark("half-way", session);
        if (i == 400) session.reset();
        session.step(anyInput(random));
        fingerprints.push_back(session.fingerprint());
    }
    return fingerprints;
}

Recording readBack(const Recording& recording) {
    ReadRecording read = readRecording(writeRecording(recording), "field.txt");
    for (const Fault& fault : read.faults) ADD_FAILURE() << describe(fault);
    return read.recording.value_or(Recording{});
}

TEST(Recording, ReplaysTheSameStates) {
    Session session(makeField());
    Recorder recorder("field");
    session.record(&recorder);
    const std::vector<std::uint64_t> played = playAnything(session, recorder, 500);
    const Recording recording = recorder.finish(session);
    EXPECT_EQ(recording.steps, 500);

    Session again(makeField());
    Replay replay(readBack(recording));
    for (const std::uint64_t fingerprint : played) {
        ASSERT_TRUE(replay.step(again));
        ASSERT_EQ(again.fingerprint(), fingerprint) << "after " << replay.stepsDone() << " steps";
    }
    EXPECT_FALSE(replay.step(again));
    EXPECT_TRUE(replay.isOver());
    EXPECT_EQ(again.fingerprint(), played.back());
    EXPECT_EQ(again.steps(), 500);
    ASSERT_EQ(replay.marks().size(), 1u);
    EXPECT_EQ(replay.marks()[0].name, "half-way");
    EXPECT_EQ(replay.marks()[0].step, 350);
    EXPECT_TRUE(replay.marks()[0].isSame);
    EXPECT_TRUE(replay.isSame());
    EXPECT_EQ(again.option("speed"), "2.5");
    EXPECT_EQ(again.option("fov"), "60");
}

TEST(Recording, RecordingAReplayGivesTheSame) {
    Session session(makeField());
    Recorder recorder("field");
    session.record(&recorder);
    playAnything(session, recorder, 500);
    const std::string text = writeRecording(recorder.finish(session));

    Session again(makeField());
    Recorder second("field");
    Replay replay(readBack(recorder.finish(session)));
    // The second recording sets its first options twice: at its start, and by the replay.
    again.record(&second);
    while (replay.step(again)) {
        if (again.steps() == 350) second.mark("half-way", again);
    }
    const std::string doubled = writeRecording(second.finish(again));
    const std::string firstOption = "set speed 1\nset bob on\n";
    const std::size_t at = doubled.find(firstOption);
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(doubled.substr(0, at) + doubled.substr(at + firstOption.size()), text);
}

TEST(Recording, NoticesAnotherWorld) {
    Session session(makeField());
    Recorder recorder("field");
    session.record(&recorder);
    for (int i = 0; i < 400; ++i) session.step({.forward = 1.0});
    recorder.mark("at-the-block", session);
    const Recording recording = recorder.finish(session);

    World without = makeField();
    without.maps[0].setCell(14, 10, 0, kEmptyCell);
    Session other(std::move(without));
    Replay replay(recording);
    while (replay.step(other)) {
    }
    ASSERT_EQ(replay.marks().size(), 1u);
    EXPECT_FALSE(replay.marks()[0].isSame);
    EXPECT_FALSE(replay.isSame());
}

// The field under water that is deep enough to swim.
World makeFloodedField() {
    World world = makeField();
    CellBlueprint water;
    water.isWater = true;
    water.top = toCoordinate(0.46);
    world.blueprints.push_back(water);
    Map& map = world.maps[0];
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            if (map.cell(x, y, 0) == kEmptyCell)
                map.setCell(x, y, 0, static_cast<BlueprintId>(world.blueprints.size() - 1));
        }
    }
    return world;
}

// An option is recorded exactly if it changes where the player gets to.
TEST(Recording, HoldsTheOptionsThatAffectSteps) {
    for (const OptionInfo& info : knownOptions()) {
        const std::string name = info.name;
        Session plain(makeFloodedField());
        Session set(makeFloodedField());
        // A value other than the standard: a number, or a word that a refusal names.
        std::string refusal = set.setOption(name, "?");
        std::vector<std::string> values = {"3", "0.5", "70",
                                           std::to_string(static_cast<int>(info.greatest))};
        for (std::size_t quote = refusal.find(" '"); quote != std::string::npos;
             quote = refusal.find(" '", quote + 1)) {
            values.push_back(refusal.substr(quote + 2, refusal.find('\'', quote + 2) - quote - 2));
        }
        for (const std::string& value : values) {
            if (value != info.standard && set.setOption(name, value).empty()) break;
        }
        ASSERT_NE(set.option(name), info.standard) << name;
        for (int i = 0; i < 30; ++i) {
            plain.step({.forward = 1.0, .turn = 0.5});
            set.step({.forward = 1.0, .turn = 0.5});
        }
        EXPECT_EQ(poseOf(plain) != poseOf(set), isRecordedOption(name)) << name;
    }
}

TEST(Recording, InputsAreStoredAndAppliedInUnits) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const RecordedInput kept = toRecorded({.forward = 7.0,
                                           .strafe = nan,
                                           .turn = -0.5,
                                           .look = 0.001,
                                           .turnDegrees = 1.0,
                                           .lookHeights = -0.25,
                                           .slow = true});
    const RecordedInput expected = {
        .forward = 256, .turn = -128, .turnDegrees = 1024, .lookHeights = -16384, .slow = true};
    EXPECT_EQ(kept, expected);
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const RecordedInput once = toRecorded(anyInput(random));
        EXPECT_EQ(toRecorded(toInput(once)), once);
    }
}

TEST(Recording, EqualInputsAreOneLine) {
    Session session(makeField());
    Recorder recorder("field");
    session.record(&recorder);
    for (int i = 0; i < 90; ++i) session.step({.forward = 1.0});
    for (int i = 0; i < 30; ++i) session.step({.forward = 1.0, .jump = true});
    session.setFlying(true);
    const std::string text = writeRecording(recorder.finish(session));
    EXPECT_EQ(text.substr(0, text.rfind(' ')),
              "slicecast recording 1\nscene field\nset speed 1\nset bob on\n90 forward 256\n"
              "30 forward 256 jump\nfly on\nend 120");
}

// ---- faulty texts

const std::string kHead = "slicecast recording 1\nscene field\n";
const std::string kTail = "end 5 0123456789abcdef\n";

std::string faultsOf(const std::string& text) {
    const ReadRecording read = readRecording(text, "f");
    EXPECT_EQ(read.recording.has_value(), read.faults.empty()) << "nothing half loaded";
    std::string words;
    for (const Fault& fault : read.faults) words += describe(fault) + "\n";
    return words;
}

TEST(Recording, AValidTextHasNoFaults) {
    EXPECT_EQ(faultsOf(kHead +
                       "# a comment\n\n  5   forward 256 turn -12  look-heights 655 jump fast slow "
                       "\nfly off\r\n" +
                       kTail),
              "");
    EXPECT_EQ(faultsOf("\xef\xbb\xbf" + kHead + "5\n" + kTail), "");
}

TEST(Recording, FaultsHaveTheirPlaces) {
    const std::string words =
        "forward, strafe, turn, look, fly, turn-degrees, look-heights, jump, fast, slow, use, open "
        "or close";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "f:1:1: found the end of the file, expected \"slicecast recording 1\"\n"},
        {"{\"title\": 1}",
         "f:1:1: found \"{\\\"title\\\":\", expected \"slicecast recording 1\"\n"},
        {"slicecast recording 2\nscene field\n",
         "f:1:1: found \"slicecast\", expected \"slicecast recording 1\"\n"},
        {"slicecast recording 1\n",
         "f:2:1: found the end of the file, expected \"scene\" and its name\n"},
        {"slicecast recording 1\n5\n" + kTail,
         "f:2:1: found \"5\", expected \"scene\" and its name\nf:3:5: found \"5\", expected 0, the "
         "sum of all steps\n"},
        {"slicecast recording 1\nscene ../x\n5\n" + kTail,
         "f:2:7: found \"../x\", expected the scene's name, of at most 60 letters, digits, '-', "
         "'_' and '.'\n"},
        {kHead + "5\n",
         "f:4:1: found the end of the file, expected \"end\", which proves that the "
         "recording is complete\n"},
        {kHead + "4\n" + kTail, "f:4:5: found \"5\", expected 4, the sum of all steps\n"},
        {kHead + "5\n" + kTail + "1\n",
         "f:5:1: found \"1\", expected nothing after the end of the recording\n"},
        {kHead + "5\nend 5\n",
         "f:4:6: found the end of the line, expected the pose of the eye, 16 digits from 0 to f\n"},
        {kHead + "5\nend 5 0123456789ABCDEF\n",
         "f:4:7: found \"0123456789ABCDEF\", expected the pose of the eye, 16 digits from 0 to "
         "f\n"},
        {kHead + "0\n" + kTail,
         "f:3:1: found \"0\", expected a number of steps, a whole number from 1 to 4320000\n"},
        {kHead + "5x\n" + kTail,
         "f:3:1: found \"5x\", expected a number of steps, a whole number from 1 to 4320000\n"},
        {kHead + "4320000\n1\nend 5 0123456789abcdef\n",
         "f:4:2: found the end of the line, expected at most 4320000 steps in all\n"},
        {kHead + "99999999999999999999\n" + kTail,
         "f:3:1: found \"99999999999999999999\", expected a number of steps, a whole number from 1 "
         "to 4320000\n"},
        {kHead + "5 forward 257\n" + kTail,
         "f:3:11: found \"257\", expected how much, a whole number from -256 to 256\n"},
        {kHead + "5 forward 0.5\n" + kTail,
         "f:3:11: found \"0.5\", expected how much, a whole number from -256 to 256\n"},
        {kHead + "5 forward\n" + kTail,
         "f:3:10: found the end of the line, expected how much, a whole number from -256 to 256\n"},
        {kHead + "5 forwards 1\n" + kTail, "f:3:3: found \"forwards\", expected " + words + "\n"},
        {kHead + "5 jump jump\n" + kTail, "f:3:8: found \"jump\", expected each word once\n"},
        {kHead + "walk\n5\n" + kTail,
         "f:3:1: found \"walk\", expected a number of steps, fly, level, heading, eye, cell, "
         "reset, "
         "set, "
         "mark or end\n"},
        {kHead + "fly up\n5\n" + kTail, "f:3:5: found \"up\", expected on or off\n"},
        {kHead + "fly on off\n5\n" + kTail, "f:3:8: found \"off\", expected the end of the line\n"},
        {kHead + "heading 400000\n5\n" + kTail,
         "f:3:9: found \"400000\", expected the heading, a whole number from 0 to 368640\n"},
        {kHead + "eye 0 1 1 0 0 0\n5\n" + kTail,
         "f:3:11: found \"0\", expected z, a whole number from 1 to 2147418112\n"},
        {kHead + "set fov 70\n5\n" + kTail,
         "f:3:5: found \"fov\", expected an option that affects steps: speed or bob\n"},
        {kHead + "set speed 99\n5\n" + kTail,
         "f:3:11: found \"99\", expected a value of the option speed\n"},
        {kHead + "mark\n5\n" + kTail,
         "f:3:5: found the end of the line, expected the mark's name, of at most 60 letters, "
         "digits, '-', '_' and '.'\n"},
        {kHead + "mark x y\n5\n" + kTail,
         "f:3:8: found \"y\", expected the pose of the eye, 16 digits from 0 to f\n"},
        {kHead + "5 \xff\n" + kTail,
         "f:3:3: found a byte that is not UTF-8, expected a recording, which is UTF-8 text\n"},
        // Two lines, two faults in the first: each line reports its first
        {kHead + "5 a b\nfly\n" + kTail,
         "f:3:3: found \"a\", expected " + words +
             "\nf:4:4: found the end of the line, expected on or off\n"},
    };
    for (const auto& [text, faults] : cases) EXPECT_EQ(faultsOf(text), faults) << text;
}

// Any damage to a text is a fault or another sound recording; nothing else happens.
TEST(Recording, DamagedTextsAreRefusedOrValid) {
    Session session(makeField());
    Recorder recorder("field");
    session.record(&recorder);
    playAnything(session, recorder, 420);
    const std::string text = writeRecording(recorder.finish(session));
    Random random(5);
    for (int i = 0; i < 600; ++i) {
        std::string damaged = text;
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
        if (random.oneIn(2)) {
            damaged[at] = static_cast<char>(random.below(256));
        } else {
            damaged.resize(at);
            EXPECT_NE(faultsOf(damaged), "") << "a part is not the whole";
        }
        const ReadRecording read = readRecording(damaged, "f");
        EXPECT_EQ(read.recording.has_value(), read.faults.empty());
        if (!read.recording) continue;
        EXPECT_NE(writeRecording(*read.recording), "");
    }
}

}  // namespace
}  // namespace slicecast
