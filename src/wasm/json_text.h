// Writes JSON, value after value.
//
//     JsonText json;
//     json.beginObject();
//     json.key("name").text("brick");
//     json.key("sizes").beginArray().number(8).number(0.5).endArray();
//     json.endObject();                                                     {"name":"brick","sizes":[8,0.5]}
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
    JsonText& number(double value);          // finite; every bit of it comes back when it is read
    JsonText& yesNo(bool value);

    const std::string& str() const { return out_; }

private:
    JsonText& open(char bracket);
    JsonText& close(char bracket);
    void separate();
    void quote(std::string_view value);

    std::string out_;
    bool needsComma_ = false;
};

}  // namespace slicecast
