// Writes JSON, value after value.
//
//     JsonText json;
//     json.beginObject();
//     json.key("name").text("brick");
//     json.key("sizes").beginArray().number(8).number(0.5).endArray();
//     json.endObject(); {"name":"brick","sizes":[8,0.5]}
//
// Everything stands in one line, except what is told to begin a new one.
#pragma once

#include <string>
#include <string_view>

namespace slicecast {

class JsonText {
public:
    JsonText& beginObject() { return open('{'); }
    JsonText& endObject() { return close('}'); }
    JsonText& beginArray() { return open('['); }
    JsonText& endArray() { return close(']'); }
    JsonText& key(std::string_view name);
    JsonText& text(std::string_view value);  // UTF-8
    JsonText& number(
        double value);  // every bit of it comes back when it is read; null where it is not finite
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

}  // namespace slicecast
