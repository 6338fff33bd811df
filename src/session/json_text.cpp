#include "session/json_text.h"

#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast {

void JsonText::growPacked() {
    packed_->numbers.resize(2 * packed_->count + 1024);
}

double JsonText::indexOf(std::string_view text) {
    std::vector<std::string>& texts = packed_->texts;
    const auto known = std::find(texts.begin(), texts.end(), text);
    const auto index = static_cast<double>(known - texts.begin());
    if (known == texts.end()) texts.emplace_back(text);
    return index;
}

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
    if (packed_ != nullptr) {
        // An object among an array's elements counts there, and takes no place of its own.
        if (bracket == '[') {
            pack(0.0);
            open_.push_back(packed_->count - 1);
        } else {
            if (!open_.empty() && open_.back() != kObject) packed_->numbers[open_.back()] += 1.0;
            open_.push_back(kObject);
        }
        return *this;
    }
    separate();
    out_ += bracket;
    needsComma_ = false;
    return *this;
}

JsonText& JsonText::close(char bracket) {
    if (packed_ != nullptr) {
        open_.pop_back();
        return *this;
    }
    beginLine();
    out_ += bracket;
    needsComma_ = true;
    return *this;
}

JsonText& JsonText::key(const char* name, std::size_t size) {
    if (packed_ != nullptr) return *this;
    separate();
    quote({name, size});
    out_ += ':';
    needsComma_ = false;
    return *this;
}

JsonText& JsonText::text(std::string_view value) {
    if (packed_ != nullptr) {
        packText(value);
        return *this;
    }
    separate();
    quote(value);
    return *this;
}

JsonText& JsonText::number(double value) {
    if (!std::isfinite(value)) return null();
    if (packed_ != nullptr) {
        pack(value);
        return *this;
    }
    separate();
    out_ += std::string_view(shortestText(value));
    return *this;
}

JsonText& JsonText::pair(double a, double b) {
    return beginArray().number(a).number(b).endArray();
}

JsonText& JsonText::yesNo(bool value) {
    if (packed_ != nullptr) {
        pack(value ? 1.0 : 0.0);
        return *this;
    }
    separate();
    out_ += value ? "true" : "false";
    return *this;
}

JsonText& JsonText::null() {
    if (packed_ != nullptr) {
        pack(std::numeric_limits<double>::quiet_NaN());
        return *this;
    }
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
