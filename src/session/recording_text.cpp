#include "session/recording_text.h"

#include "base/coordinate.h"
#include "base/number_text.h"
#include "base/words.h"
#include "scene/checker.h"
#include "scene/limits.h"
#include "scene/source_text.h"
#include "session/options.h"
#include "slicecast/picture.h"
#include "world/limits.h"
#include "world/player.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

constexpr std::string_view kFirstLine = "slicecast recording ";

// The words of a step, in the order in which they are written.
struct Amount {
    std::string_view word;
    int RecordedInput::*member;
    int most;
};
constexpr std::array kAmounts = {
    Amount{"forward", &RecordedInput::forward, kRecordedAxis},
    Amount{"strafe", &RecordedInput::strafe, kRecordedAxis},
    Amount{"turn", &RecordedInput::turn, kRecordedAxis},
    Amount{"look", &RecordedInput::look, kRecordedAxis},
    Amount{"fly", &RecordedInput::fly, kRecordedAxis},
    Amount{"turn-degrees", &RecordedInput::turnDegrees, kMaxRecordedDegrees* kRecordedDegree},
    Amount{"look-heights", &RecordedInput::lookHeights, kMaxRecordedHeights* kRecordedHeight},
};
struct Button {
    std::string_view word;
    bool RecordedInput::*member;
};
constexpr std::array kButtons = {
    Button{"jump", &RecordedInput::jump}, Button{"fast", &RecordedInput::fast},
    Button{"slow", &RecordedInput::slow}, Button{"use", &RecordedInput::use},
    Button{"open", &RecordedInput::open}, Button{"close", &RecordedInput::close},
};

// ---- writing

struct Writer {
    std::string& out;

    void operator()(const RecordedSteps& entry) const {
        add(out, entry.count);
        for (const Amount& amount : kAmounts) {
            const int value = entry.input.*amount.member;
            if (value != 0) add(out, {" ", amount.word, " ", value});
        }
        for (const Button& button : kButtons) {
            if (entry.input.*button.member) add(out, {" ", button.word});
        }
    }
    void operator()(const RecordedFlying& entry) const {
        out += entry.flying ? "fly on" : "fly off";
    }
    void operator()(const RecordedLevelLook&) const { out += "level"; }
    void operator()(const RecordedHeading& entry) const { add(out, {"heading ", entry.heading}); }
    void operator()(const RecordedReset&) const { out += "reset"; }
    void operator()(const RecordedEye& entry) const {
        out += "eye";
        for (const int number : {entry.map, entry.x, entry.y, entry.z, entry.heading, entry.look})
            add(out, {" ", number});
    }
    void operator()(const RecordedCell& entry) const {
        out += "cell";
        for (const int number : {entry.map, entry.level, entry.x, entry.y}) add(out, {" ", number});
        for (std::size_t offset = 0; offset < entry.sign.size();)
            add(out, {" ", static_cast<int>(takeCodePoint(entry.sign, offset))});
    }
    void operator()(const RecordedOption& entry) const {
        add(out, {"set ", entry.name, " ", entry.value});
    }
    void operator()(const RecordedMark& entry) const {
        add(out, {"mark ", entry.name, " ", hexText(entry.pose, 16)});
    }
};

// ---- reading

struct Token {
    std::string_view text;
    std::size_t offset = 0;  // in the whole text
};

struct Wrong {
    std::size_t offset = 0;
    std::string found;
    std::string expected;
};

// A name has letters, digits, '-', '_' and '.', so that it fits into a line and can name a file.
bool isName(std::string_view text) {
    if (text.empty() || text.size() > kMaxRecordedName || text[0] == '.') return false;
    for (const char c : text) {
        const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                             (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
        if (!isPlain) return false;
    }
    return true;
}

std::optional<std::int64_t> wholeNumber(std::string_view text) {
    const bool isNegative = !text.empty() && text[0] == '-';
    const std::string_view digits = text.substr(isNegative ? 1 : 0);
    if (digits.empty() || digits.size() > 15) return std::nullopt;
    std::int64_t number = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return std::nullopt;
        number = number * 10 + (c - '0');
    }
    return isNegative ? -number : number;
}

std::optional<std::uint64_t> hexNumber(std::string_view text) {
    if (text.size() != 16) return std::nullopt;
    std::uint64_t number = 0;
    for (const char c : text) {
        const bool isDigit = c >= '0' && c <= '9';
        if (!isDigit && !(c >= 'a' && c <= 'f')) return std::nullopt;
        number = number * 16 + static_cast<std::uint64_t>(isDigit ? c - '0' : c - 'a' + 10);
    }
    return number;
}

// The words of one line, taken in order. Remembers the first error, and finds no more words after
// it.
class Line {
public:
    Line(std::vector<Token> tokens, std::size_t end) : tokens_(std::move(tokens)), end_(end) {}

    bool hasMore() const { return !wrong_ && at_ < tokens_.size(); }
    std::string_view peek() const { return tokens_[at_].text; }
    const std::optional<Wrong>& wrong() const { return wrong_; }

    void refuse(const Words& expected) {
        if (wrong_) return;
        if (at_ < tokens_.size()) {
            wrong_ = Wrong{tokens_[at_].offset, quoted(tokens_[at_].text), expected.str()};
        } else {
            wrong_ = Wrong{end_, "the end of the line", expected.str()};
        }
    }
    void take() { ++at_; }

    std::int64_t number(std::int64_t least, std::int64_t greatest, const char* what) {
        const auto value = hasMore() ? wholeNumber(peek()) : std::nullopt;
        if (!value || *value < least || *value > greatest) {
            refuse({what, ", a whole number from ", least, " to ", greatest});
            return 0;
        }
        take();
        return *value;
    }
    int smallNumber(std::int64_t least, std::int64_t greatest, const char* what) {
        return static_cast<int>(number(least, greatest, what));
    }
    std::uint64_t pose() {
        const auto value = hasMore() ? hexNumber(peek()) : std::nullopt;
        if (!value) refuse("the pose of the eye, 16 digits from 0 to f");
        take();
        return value.value_or(0);
    }
    std::string name(const char* what) {
        if (!hasMore() || !isName(peek())) {
            refuse({what, ", of at most ", kMaxRecordedName, " letters, digits, '-', '_' and '.'"});
            return {};
        }
        std::string name(peek());
        take();
        return name;
    }
    void end() {
        if (hasMore()) refuse("the end of the line");
    }

private:
    std::vector<Token> tokens_;
    std::size_t end_;
    std::size_t at_ = 0;
    std::optional<Wrong> wrong_;
};

RecordedSteps readSteps(Line& line) {
    RecordedSteps steps;
    steps.count = line.number(1, kMaxRecordedSteps, "a number of steps");
    std::vector<std::string_view> seen;
    while (line.hasMore()) {
        const std::string_view word = line.peek();
        for (const std::string_view earlier : seen) {
            if (earlier == word) line.refuse("each word once");
        }
        seen.push_back(word);
        bool isKnown = false;
        for (const Amount& amount : kAmounts) {
            if (amount.word != word || !line.hasMore()) continue;
            isKnown = true;
            line.take();
            steps.input.*amount.member = line.smallNumber(-amount.most, amount.most, "how much");
        }
        for (const Button& button : kButtons) {
            if (button.word != word || isKnown || !line.hasMore()) continue;
            isKnown = true;
            line.take();
            steps.input.*button.member = true;
        }
        if (!isKnown)
            line.refuse(
                "forward, strafe, turn, look, fly, turn-degrees, look-heights, jump, fast, slow, "
                "use, open or close");
    }
    return steps;
}

RecordedEye readEye(Line& line) {
    constexpr int kMost = static_cast<int>(kCoordinateLimit) * kRecordedHeight;
    constexpr int kMostLook = static_cast<int>(kMaxLook) * kRecordedHeight;
    RecordedEye eye;
    eye.map = line.smallNumber(0, 65535, "the map's index");
    eye.x = line.smallNumber(-kMost, kMost, "x");
    eye.y = line.smallNumber(-kMost, kMost, "y");
    eye.z = line.smallNumber(1, kMost, "z");
    eye.heading = line.smallNumber(0, 360 * kRecordedDegree, "the heading");
    eye.look = line.smallNumber(-kMostLook, kMostLook, "the look");
    return eye;
}

RecordedCell readCell(Line& line) {
    RecordedCell cell;
    cell.map = line.smallNumber(0, 65535, "the map's index");
    cell.level = line.smallNumber(0, kMaxLevels - 1, "the level");
    cell.x = line.smallNumber(0, kMaxMapWidth - 1, "the cell's x");
    cell.y = line.smallNumber(0, kMaxMapDepth - 1, "the cell's y");
    do {
        const int character = line.smallNumber(1, 0x10ffff, "a Unicode character number");
        cell.sign += toUtf8(static_cast<char32_t>(character));
    } while (line.hasMore());
    return cell;
}

RecordedOption readOption(Line& line) {
    RecordedOption option;
    if (!line.hasMore() || !isRecordedOption(line.peek())) {
        line.refuse("an option that affects steps: speed or bob");
        return option;
    }
    option.name = line.peek();
    line.take();
    if (line.hasMore()) {
        option.value = line.peek();
        SessionOptions unused;
        if (setOption(unused, option.name, option.value).empty()) {
            line.take();
            return option;
        }
    }
    line.refuse({"a value of the option ", option.name});
    return option;
}

// Reads a line between the first two and the last one.
std::optional<RecordedEntry> readEntry(Line& line) {
    const std::string_view word = line.peek();
    if (word[0] >= '0' && word[0] <= '9') return readSteps(line);
    if (word == "fly") {
        line.take();
        const bool isOn = line.hasMore() && line.peek() == "on";
        if (!isOn && !(line.hasMore() && line.peek() == "off")) line.refuse("on or off");
        line.take();
        return RecordedFlying{isOn};
    }
    if (word == "level" || word == "reset") {
        line.take();
        return word == "level" ? RecordedEntry(RecordedLevelLook{})
                               : RecordedEntry(RecordedReset{});
    }
    if (word == "heading") {
        line.take();
        return RecordedHeading{line.smallNumber(0, 360 * kRecordedDegree, "the heading")};
    }
    if (word == "eye") {
        line.take();
        return readEye(line);
    }
    if (word == "cell") {
        line.take();
        return readCell(line);
    }
    if (word == "set") {
        line.take();
        return readOption(line);
    }
    if (word == "mark") {
        line.take();
        RecordedMark mark;
        mark.name = line.name("the mark's name");
        mark.pose = line.pose();
        return mark;
    }
    line.refuse("a number of steps, fly, level, heading, eye, cell, reset, set, mark or end");
    return std::nullopt;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& fileName)
        : source_(text), fileName_(fileName) {}

    ReadRecording read() {
        const std::string_view text = source_.text();
        if (text.size() > kMaxRecordingBytes) {
            addWrong({0, words(text.size(), " bytes"),
                      words("a recording of at most ", kMaxRecordingBytes, " bytes")});
        } else if (source_.invalidByte()) {
            addWrong({*source_.invalidByte(), "a byte that is not UTF-8",
                      "a recording, which is UTF-8 text"});
        } else {
            readLines(text);
        }
        ReadRecording result;
        if (omitted_ > 0) faults_.push_back(moreFaults(fileName_, omitted_));
        if (faults_.empty()) result.recording = std::move(recording_);
        result.faults = std::move(faults_);
        return result;
    }

private:
    enum class Next { version, scene, entries, nothing };

    void readLines(std::string_view text) {
        std::size_t begin = source_.start();
        while (begin < text.size()) {
            const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
            std::vector<Token> tokens = tokensOf(text, begin, end);
            if (!tokens.empty() && tokens[0].text[0] != '#') {
                const bool goesOn =
                    readLine(Line(std::move(tokens), end), text.substr(begin, end - begin));
                if (!goesOn) return;
            }
            begin = end + 1;
        }
        if (next_ != Next::nothing) addWrong({text.size(), "the end of the file", expectedNext()});
    }

    static std::vector<Token> tokensOf(std::string_view text, std::size_t begin, std::size_t end) {
        std::vector<Token> tokens;
        while (begin < end) {
            const std::size_t first = text.find_first_not_of(" \t", begin);
            if (first >= end) break;
            const std::size_t last = std::min(text.find_first_of(" \t\r\n", first), end);
            tokens.push_back({text.substr(first, last - first), first});
            begin = last;
        }
        return tokens;
    }

    std::string expectedNext() const {
        switch (next_) {
            case Next::version:
                return words("\"", kFirstLine, kRecordingVersion, "\"");
            case Next::scene:
                return "\"scene\" and its name";
            case Next::entries:
                return "\"end\", which proves that the recording is complete";
            case Next::nothing:
                break;
        }
        return "nothing after the end of the recording";
    }

    // False if it makes no sense to read on.
    bool readLine(Line line, std::string_view whole) {
        switch (next_) {
            case Next::version:
                if (whole != words(kFirstLine, kRecordingVersion)) {
                    line.refuse(expectedNext());
                    addFaultOf(line);
                    return false;
                }
                next_ = Next::scene;
                return true;
            case Next::scene:
                next_ = Next::entries;
                if (line.peek() != "scene") {
                    line.refuse("\"scene\" and its name");
                } else {
                    line.take();
                    recording_.scene = line.name("the scene's name");
                }
                break;
            case Next::entries:
                readEntryLine(line);
                break;
            case Next::nothing:
                line.refuse(expectedNext());
                break;
        }
        line.end();
        addFaultOf(line);
        return true;
    }

    void readEntryLine(Line& line) {
        if (line.peek() == "end") {
            next_ = Next::nothing;
            line.take();
            if (isSumKnown_ && line.hasMore() && wholeNumber(line.peek()) != recording_.steps) {
                line.refuse({recording_.steps, ", the sum of all steps"});
            }
            line.take();
            recording_.endPose = line.pose();
            return;
        }
        const std::optional<RecordedEntry> entry = readEntry(line);
        if (entry && !line.wrong()) {
            if (const auto* steps = std::get_if<RecordedSteps>(&*entry))
                recording_.steps += steps->count;
            if (recording_.steps > kMaxRecordedSteps && isSumKnown_) {
                isSumKnown_ = false;
                line.refuse({"at most ", kMaxRecordedSteps, " steps in all"});
            }
            recording_.entries.push_back(*entry);
        } else {
            isSumKnown_ = false;
        }
    }

    void addFaultOf(const Line& line) {
        if (line.wrong()) addWrong(*line.wrong());
    }

    void addWrong(const Wrong& wrong) {
        if (faults_.size() >= kMaxFaults) {
            ++omitted_;
            return;
        }
        const TextPosition place = source_.place(wrong.offset);
        Fault fault;
        fault.file = fileName_;
        fault.line = place.line;
        fault.column = place.column;
        fault.found = wrong.found;
        fault.expected = wrong.expected;
        faults_.push_back(std::move(fault));
    }

    SourceText source_;
    std::string fileName_;
    Recording recording_;
    Next next_ = Next::version;
    bool isSumKnown_ = true;
    std::vector<Fault> faults_;
    std::size_t omitted_ = 0;
};

}  // namespace

std::string writeRecording(const Recording& recording) {
    std::string text = words(kFirstLine, kRecordingVersion, "\nscene ", recording.scene, "\n");
    for (const RecordedEntry& entry : recording.entries) {
        std::visit(Writer{text}, entry);
        text += "\n";
    }
    add(text, {"end ", recording.steps, " ", hexText(recording.endPose, 16), "\n"});
    return text;
}

ReadRecording readRecording(std::string_view text, const std::string& fileName) {
    return Reader(text, fileName).read();
}

}  // namespace slicecast
