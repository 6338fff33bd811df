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
// The same values can be packed instead, which takes a tenth of the time to write and to read. The
// numbers then stand one after another, for a reader that knows their order (web/engine's
// read-traces.js):
//
//     number              itself; NaN where JSON has null
//     text                its index in PackedValues::texts; NaN for null
//     true, false         1, 0
//     array               how many elements it has, and then those
//     object              its members' values; keys are left out
#pragma once

#include <cstddef>
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
    JsonText() = default;
    // Packs everything there, and writes no text. The texts that it is given must outlive it.
    explicit JsonText(PackedValues& packed) : packed_(&packed) {}

    JsonText& beginObject() { return open('{'); }
    JsonText& endObject() { return close('}'); }
    JsonText& beginArray() { return open('['); }
    JsonText& endArray() { return close(']'); }
    JsonText& key(std::string_view name) { return key(name.data(), name.size()); }
    // Of a literal the length is known, which spares counting it.
    template <std::size_t size>
    JsonText& key(const char (&name)[size]) {
        return key(name, size - 1);
    }
    JsonText& text(std::string_view value);  // UTF-8
    JsonText& number(
        double value);  // every bit of it comes back when it is read; null where it is not finite
    JsonText& pair(double a, double b);  // an array of two numbers
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

    JsonText& key(const char* name, std::size_t size);
    void pack(double value);
    void growPacked();
    double indexOf(std::string_view text);
    void packText(std::string_view value);

    static constexpr std::size_t kObject = static_cast<std::size_t>(-1);

    // Texts that were packed lately, by where they stand in memory.
    struct PackedText {
        const char* data = nullptr;
        std::size_t size = 0;
        double index = 0.0;
    };
    static constexpr std::size_t kPackedTexts = 64;

    PackedValues* packed_ = nullptr;
    PackedText packedTexts_[kPackedTexts];
    std::vector<std::size_t> open_;  // brackets: where an array's length stands, or kObject
    std::string out_;
    bool needsComma_ = false;
    int steps_ = -1;  // of the line to begin; -1 for none
};

}  // namespace slicecast
