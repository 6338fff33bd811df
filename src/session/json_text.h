// Writes JSON, value after value.
//
//     JsonText json;
//     json.beginObject();
//     json.key("name").text("brick");
//     json.key("sizes").beginArray().number(8).number(0.5).endArray();
//     json.endObject(); {"name":"brick","sizes":[8,0.5]}
//
// Everything stands in one line, except what is told to begin a new one.
//
// PackedJson takes the same values and writes no text. Reading and writing them then takes a tenth
// of the time. Numbers stand one after another, for a reader that knows their order
// (web/engine/read-packed.js):
//
//     number              itself; NaN where JSON has null
//     text                its index in PackedValues::texts; NaN for null
//     true, false         1, 0
//     list                how many elements it has, how many numbers those are, and then those
//     tuple               its elements: their number is known
//     object              its members' values; keys are left out
//
// What writes either is a template of which it is.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

struct PackedValues {
    std::vector<double> numbers;  // the first `count` of them
    std::size_t count = 0;
    std::vector<std::string> texts;

    // Forgets all but the memory.
    void clear() {
        count = 0;
        texts.clear();
    }
};

class JsonText {
public:
    JsonText& beginObject() { return open('{'); }
    JsonText& endObject() { return close('}'); }
    JsonText& beginArray() { return open('['); }
    JsonText& beginList(std::size_t) { return open('['); }  // of so many elements
    JsonText& beginTuple() { return open('['); }
    JsonText& endList() { return close(']'); }
    JsonText& endArray() { return close(']'); }  // also of a tuple
    JsonText& key(std::string_view name);
    JsonText& text(std::string_view value);  // UTF-8
    JsonText& number(
        double value);  // every bit of it comes back when it is read; null where it is not finite
    JsonText& pair(double a, double b);  // a tuple of two numbers
    JsonText& yesNo(bool value);
    JsonText& null();

    // The next key, value or closing bracket begins a line, so many steps in.
    JsonText& line(int steps);

    const std::string& str() const { return out_; }

private:
    JsonText& open(char bracket);
    JsonText& close(char bracket);
    void separate();
    void beginLine();
    void quote(std::string_view value);

    std::string out_;
    bool needsComma_ = false;
    int steps_ = -1;  // of the line to begin; -1 for none
};

class PackedJson {
public:
    // The texts that it is given must outlive it.
    explicit PackedJson(PackedValues& packed) : packed_(packed) {}

    PackedJson& beginObject() { return *this; }
    PackedJson& endObject() { return *this; }
    PackedJson& beginList(std::size_t count);
    PackedJson& endList();
    PackedJson& beginTuple() { return *this; }
    PackedJson& endArray() { return *this; }
    PackedJson& key(const char*) { return *this; }
    PackedJson& text(const char* value);  // ends with a 0
    PackedJson& text(const std::string& value) { return text(value.c_str()); }
    __attribute__((always_inline)) PackedJson& number(double value) {
        return pack(value - value == 0.0 ? value : kNull);
    }
    PackedJson& pair(double a, double b) { return number(a).number(b); }
    PackedJson& yesNo(bool value) { return pack(value ? 1.0 : 0.0); }
    PackedJson& null() { return pack(kNull); }
    PackedJson& line(int) { return *this; }

private:
    // Inlined always: it runs a million times for all columns of a picture.
    __attribute__((always_inline)) PackedJson& pack(double value) {
        if (packed_.count == packed_.numbers.size()) grow();
        packed_.numbers[packed_.count++] = value;
        return *this;
    }
    void grow();
    static constexpr double kNull = std::numeric_limits<double>::quiet_NaN();
    double indexOf(const char* text);

    // Texts that were packed lately, by where they stand in memory.
    struct PackedText {
        const char* data = nullptr;
        double index = 0.0;
    };
    static constexpr std::size_t kPackedTexts = 64;
    static constexpr std::size_t kDeepestList = 8;

    PackedValues& packed_;
    PackedText packedTexts_[kPackedTexts];
    std::size_t lists_[kDeepestList];  // where the elements of the open lists begin
    std::size_t openLists_ = 0;
};

}  // namespace slicecast
