#include "answers/json_text.h"

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
    const auto escape = [&](unsigned char c) {
        out_ += "\\u";
        out_ += std::string_view(hexText(c, 4));
    };
    for (std::size_t i = 0; i < value.size(); ++i) {
        const char c = value[i];
        const auto byte = static_cast<unsigned char>(c);
        const unsigned char next =
            i + 1 < value.size() ? static_cast<unsigned char>(value[i + 1]) : 0;
        if (c == '"' || c == '\\') {
            out_ += '\\';
            out_ += c;
        } else if (byte < 0x20 || byte == 0x7f) {
            escape(byte);
        } else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {
            // JSON allows these control characters, but a terminal obeys them
            escape(next);
            ++i;
        } else {
            out_ += c;
        }
    }
    out_ += '"';
}

}  // namespace slicecast
