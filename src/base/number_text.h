// Numbers to decimal text and back: correctly rounded, so that the text, the bits and all that
// follows from them are the same from every compiler and its library. (Those of C, which can do far
// more, brought 23 KB of code into a page.)
//
// Source of the way: exact decimals that are doubled and halved, as in Clinger, "How to Read
// Floating Point Numbers Accurately" (1990), and in Steele and White, "How to Print Floating-Point
// Numbers Accurately" (1990), in their plainest form.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace slicecast {

// The characters of one number, without an allocation.
class NumberText {
public:
    operator std::string_view() const {
        return {characters_.data(), static_cast<std::size_t>(length_)};
    }
    void add(char character) { characters_[static_cast<std::size_t>(length_++)] = character; }

private:
    std::array<char, 40> characters_{};
    int length_ = 0;
};

NumberText wholeText(std::int64_t number);

// The least significant digits in base 16: digits lower-case, 1 to 16 of them.
NumberText hexText(std::uint64_t number, int digits);

// The first of 15, 16 and 17 significant digits that give the number back, without zeros at the
// end: 0.1, 60, -1.5e-07, 1e+21; beyond 15 digits before the point or 4 zeros behind it with an
// exponent. The number is finite.
NumberText shortestText(double number);

// Rounded to `decimals` digits after the point, 0 to 6, halves to even digits: 2.50. From 1e15 on
// as shortestText. The number is finite.
NumberText fixedText(double number, int decimals);

// Rounded to `digits` significant digits, 1 to 17, halves to even digits; in the form of
// shortestText. The number is finite.
NumberText roundedText(double number, int digits);

// The nearest number, halves to the even one; infinite where it is too large. The whole text must
// be digits with at most one point, a sign before and an exponent behind them, if any: -12.5e3.
// Nothing else: no space, no "inf", no hexadecimal.
std::optional<double> readNumber(std::string_view text);

}  // namespace slicecast
