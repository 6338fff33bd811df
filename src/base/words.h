// Builds texts from texts and numbers, with little code at each call:
//
//     words("at most ", kMaxLevels, " in a map")
//     words("x ", Fixed{1.5, 2})                                            "x 1.50"
//     words("a level of ", Counted{3, "row"})                               "a level of 3 rows"
#pragma once

#include "base/number_text.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace slicecast {

// Numbers to print (base/number_text.h): Fixed with 0 to 6 digits after the point, Shortest with
// the fewest digits that are read back as the same number.
struct Fixed {
    double number;
    int decimals;
};
struct Shortest {
    double number;
};
// "1 row", "3 rows"
struct Counted {
    std::int64_t count;
    const char* noun;  // in the singular; "s" makes the plural
};

// A text or a number. A text is not copied: it must outlive the word.
class Word {
public:
    Word(std::string_view text)
        : text_(text.data()), kind_(kText), whole_(static_cast<std::int64_t>(text.size())) {}
    Word(const std::string& text) : Word(std::string_view(text)) {}
    Word(const NumberText& text) : Word(std::string_view(text)) {}
    Word(const char* text) : text_(text), kind_(kTextToZero) {}
    Word(std::integral auto number) : kind_(kWhole), whole_(static_cast<std::int64_t>(number)) {}
    Word(Counted things) : text_(things.noun), kind_(kCounted), whole_(things.count) {}
    Word(Fixed number) : kind_(number.decimals), number_(number.number) {}
    Word(Shortest number) : kind_(kShortest), number_(number.number) {}

    // Calls take(std::string_view) with each piece of its text.
    template <typename Take>
    void say(Take take) const;

private:
    static constexpr int kText = -1;
    static constexpr int kTextToZero = -2;
    static constexpr int kWhole = -3;
    static constexpr int kCounted = -4;
    static constexpr int kShortest = -5;

    const char* text_ = nullptr;
    int kind_;  // one of the above, or the decimals of a number
    union {
        std::int64_t whole_;  // or the text's length; NOLINT(readability-identifier-naming)
        double number_;       // NOLINT(readability-identifier-naming)
    };
};

// The parameter of a function that takes one word, or several in braces. It refers to its words, so
// the function must not keep it.
class Words {
public:
    Words(std::initializer_list<Word> words) : single_(0), count_(words.size()) {
        first_ = words.begin();
    }
    template <typename Piece>
        requires std::constructible_from<Word, const Piece&>
    Words(const Piece& piece) : single_(piece), first_(&single_), count_(1) {}
    Words(const Words&) = delete;
    Words& operator=(const Words&) = delete;

    const Word* begin() const { return first_; }
    const Word* end() const { return first_ + count_; }
    std::string str() const;

private:
    Word single_;
    const Word* first_;
    std::size_t count_;
};

// Appends the words to `text`.
void add(std::string& text, const Words& words);

// Writes the words into `place`, without a zero at the end; what does not fit is cut off. Returns
// what was written.
std::string_view write(std::span<char> place, const Words& words);

template <typename... Pieces>
std::string words(const Pieces&... pieces) {
    return Words({Word(pieces)...}).str();
}

}  // namespace slicecast
