#include "session/json_text.h"

#include "base/number_text.h"

#include <cmath>

namespace slicecast {

void JsonText::separate() {
    if (needsComma_) out_ += ',';
    needsComma_ = true;
    beginLine();
}

void JsonText::beginLine() {
    if (steps_ < 0) return;
    out_ += '\n';
    out_.append(2 * static_cast<std::size_t>(steps_), ' ');
    steps_ = -1;
}

JsonText& JsonText::line(int steps) {
    steps_ = steps;
    return *this;
}

JsonText& JsonText::open(char bracket) {
    separate();
    out_ += bracket;
    needsComma_ = false;
    return *this;
}

JsonText& JsonText::close(char bracket) {
    beginLine();
    out_ += bracket;
    needsComma_ = true;
    return *this;
}

JsonText& JsonText::key(std::string_view name) {
    separate();
    quote(name);
    out_ += ':';
    needsComma_ = false;
    return *this;
}

JsonText& JsonText::text(std::string_view value) {
    separate();
    quote(value);
    return *this;
}

JsonText& JsonText::number(double value) {
    if (!std::isfinite(value)) return null();
    separate();
    out_ += std::string_view(shortestText(value));
    return *this;
}

JsonText& JsonText::pair(double a, double b) {
    return beginTuple().number(a).number(b).endArray();
}

JsonText& JsonText::yesNo(bool value) {
    separate();
    out_ += value ? "true" : "false";
    return *this;
}

JsonText& JsonText::null() {
    separate();
    out_ += "null";
    return *this;
}

void JsonText::quote(std::string_view value) {
    out_ += '"';
    for (const char c : value) {
        if (c == '"' || c == '\\') {
            out_ += '\\';
            out_ += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out_ += "\\u";
            out_ += std::string_view(hexText(static_cast<unsigned char>(c), 4));
        } else {
            out_ += c;
        }
    }
    out_ += '"';
}

}  // namespace slicecast
