// Writes JSON, value after value.
//
//     JsonText json;
//     json.beginObject();
//     json.key("name").text("brick");
//     json.key("sizes").beginArray().number(8).number(0.5).endArray();
//     json.endObject();                  {"name":"brick","sizes":[8,0.5]}
//
// Everything is written into one line unless line() starts a new one.
//
// PackedJson takes the same calls and stores numbers instead of text, which takes a tenth of the
// time to write and read. The reader must know their order (web/engine/read-packed.js):
//
//     number              itself; NaN where JSON has null
//     text                its index in PackedValues::texts; NaN for null
//     true, false         1, 0
//     list                its length, the number of numbers that its elements take, and they
//     tuple               its elements; the reader knows how many
//     object              the values of its members, without keys
//
// Functions that can write either are templates of the writer.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

struct PackedValues {
    std::vector<double> numbers;  // only the first `count` are used
    std::size_t count = 0;
    std::vector<std::string> texts;

    // Empties it; keeps the memory.
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
    JsonText& beginList(std::size_t) { return open('['); }  // of this many elements
    JsonText& beginTuple() { return open('['); }
    JsonText& endList() { return close(']'); }
    JsonText& endArray() { return close(']'); }  // also of a tuple
    JsonText& key(std::string_view name);
    JsonText& text(std::string_view value);  // UTF-8
    // Reads back exactly; null if the value is not finite.
    JsonText& number(double value);
    JsonText& pair(double a, double b);  // a tuple of two numbers
    JsonText& yesNo(bool value);
    JsonText& null();

    // The next key, value or closing bracket starts a new line with this indentation.
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
    int steps_ = -1;  // indentation of the line to start; -1 for none
};

class PackedJson {
public:
    // Texts given to it must outlive it: they are told apart by their addresses.
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
    PackedJson& text(std::string&& value) = delete;
    __attribute__((always_inline)) PackedJson& number(double value) {
        return pack(value - value == 0.0 ? value : kNull);
    }
    PackedJson& pair(double a, double b) { return number(a).number(b); }
    PackedJson& yesNo(bool value) { return pack(value ? 1.0 : 0.0); }
    PackedJson& null() { return pack(kNull); }
    PackedJson& line(int) { return *this; }

private:
    // Always inlined: it runs a million times for all columns of a picture.
    __attribute__((always_inline)) PackedJson& pack(double value) {
        if (packed_.count == packed_.numbers.size()) grow();
        packed_.numbers[packed_.count++] = value;
        return *this;
    }
    void grow();
    static constexpr double kNull = std::numeric_limits<double>::quiet_NaN();
    double indexOf(const char* text);

    // A cache of recently packed texts, by their address.
    struct PackedText {
        const char* data = nullptr;
        double index = 0.0;
    };
    static constexpr std::size_t kPackedTexts = 64;
    static constexpr std::size_t kDeepestList = 8;

    PackedValues& packed_;
    PackedText packedTexts_[kPackedTexts];
    std::size_t lists_[kDeepestList];  // index of the first element of each open list
    std::size_t openLists_ = 0;
};

}  // namespace slicecast
