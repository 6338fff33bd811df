#include "base/number_text.h"
#include "sanitized.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace slicecast {
namespace {

constexpr int kNumbers = kSanitized ? 20000 : 60000;

std::string textOf(const NumberText& text) {
    return std::string(std::string_view(text));
}

std::string printed(const char* format, int digits, double number) {
    std::vector<char> text(400);
    std::snprintf(text.data(), text.size(), format, digits, number);
    return text.data();
}

// Bits of all kinds: any at all, short decimals, whole numbers, and the neighbours of these.
std::vector<double> manyNumbers() {
    std::vector<double> numbers = {0.0,
                                   -0.0,
                                   1.0,
                                   0.1,
                                   2.5,
                                   0.5,
                                   1.5,
                                   0.125,
                                   9.995,
                                   0.05,
                                   99999.5,
                                   5e-324,
                                   -5e-324,
                                   2.2250738585072014e-308,
                                   2.225073858507201e-308,
                                   std::numeric_limits<double>::max(),
                                   1e15,
                                   1e16,
                                   1e22,
                                   1e23,
                                   123456789012345678.0,
                                   9007199254740993.0,
                                   4.35,
                                   0.0001,
                                   0.00001};
    std::uint64_t state = 1;
    const auto next = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return (state >> 32) ^ (state << 20);
    };
    while (numbers.size() < kNumbers) {
        const double any = std::bit_cast<double>(next());
        if (std::isfinite(any)) numbers.push_back(any);
        const double decimal =
            static_cast<double>(next() % 1000000) / std::pow(10.0, static_cast<double>(next() % 8));
        numbers.push_back(decimal);
        numbers.push_back(std::nextafter(decimal, 1e9));
        numbers.push_back(static_cast<double>(next()) *
                          std::pow(2.0, static_cast<double>(next() % 128) - 96.0));
    }
    return numbers;
}

TEST(NumberText, ReadsAsTheLibraryDoes) {
    for (const double number : manyNumbers()) {
        for (const int digits : {3, 15, 17, 20, 40}) {
            const std::string text = printed("%.*g", digits, number);
            const double expected = std::strtod(text.c_str(), nullptr);
            const auto found = readNumber(text);
            ASSERT_TRUE(found) << text;
            ASSERT_EQ(std::bit_cast<std::uint64_t>(*found), std::bit_cast<std::uint64_t>(expected))
                << text;
        }
    }
}

// The border between two neighbours, and a hair to either side of it, with all its digits.
TEST(NumberText, RoundsAtTheBordersExactly) {
    int borders = 0;
    for (const double number : manyNumbers()) {
        if (++borders > kNumbers / 40) break;
        const double low = std::abs(number);
        const double high = std::nextafter(low, HUGE_VAL);
        if (low == 0.0 || !std::isfinite(high)) continue;
        const long double middle =
            (static_cast<long double>(low) + static_cast<long double>(high)) / 2;
        std::vector<char> text(1200);
        std::snprintf(text.data(), text.size(), "%.*Lg", 800, middle);
        const std::string exact(text.data());
        const bool isLowEven = std::bit_cast<std::uint64_t>(low) % 2 == 0;
        ASSERT_EQ(readNumber(exact), isLowEven ? low : high) << exact;
        // Something behind its last digit, past all digits that are kept
        const std::size_t exponent = exact.find('e');
        const std::string digits = exact.substr(0, exponent);
        const std::string rest = exponent == std::string::npos ? "" : exact.substr(exponent);
        const std::string padding =
            (digits.find('.') == std::string::npos ? "." : "") + std::string(900, '0');
        ASSERT_EQ(readNumber(digits + padding + "1" + rest), high) << exact;
    }
}

TEST(NumberText, ReadsNothingElse) {
    for (const char* text : {"",      "+",     "-",    ".",   "e5",    "1e",    "1e+", "1.2.3",
                             " 1",    "1 ",    "0x10", "inf", "nan",   "1,5",   "--1", "+-1",
                             "1e5.0", "1e5e5", "\r5",  "\v5", "1e\r5", "1e\v5", "1E",  "1\x05"}) {
        EXPECT_FALSE(readNumber(text)) << text;
    }
    EXPECT_EQ(readNumber("+1.5E3"), 1500.0);
    EXPECT_EQ(readNumber(".5"), 0.5);
    EXPECT_EQ(readNumber("5."), 5.0);
    EXPECT_EQ(readNumber("-0.000"), 0.0);
    EXPECT_TRUE(std::signbit(*readNumber("-0.000")));
    EXPECT_EQ(readNumber("000000000000000000000000000000000000000000000000000001"), 1.0);
    EXPECT_EQ(readNumber("1e99999999999999999999"), HUGE_VAL);
    EXPECT_EQ(readNumber("-1e309"), -HUGE_VAL);
    EXPECT_EQ(readNumber("1e-99999999999999999999"), 0.0);
    EXPECT_EQ(readNumber("0e99999999999999999999"), 0.0);
}

TEST(NumberText, ReadsHoweverManyDigitsThereAre) {
    // An exact border of few digits, and something far behind it
    EXPECT_EQ(readNumber("9223372050000000000." + std::string(800, '0') + "1"),
              9223372050000001024.0);
    EXPECT_EQ(readNumber("9223372050000000000." + std::string(800, '0')), 9223372049999998976.0);
    EXPECT_EQ(readNumber("0." + std::string(200000, '0') + "1e200001"), 1.0);
    EXPECT_EQ(readNumber("1" + std::string(200000, '0') + "e-200000"), 1.0);
}

TEST(NumberText, TheShortestGivesTheNumberBackInTheFewestDigits) {
    for (const double number : manyNumbers()) {
        const std::string text = textOf(shortestText(number));
        double back = 0.0;
        const auto end = std::from_chars(text.data(), text.data() + text.size(), back);
        ASSERT_EQ(end.ptr, text.data() + text.size()) << text;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(number)) << text;
        if (std::abs(number) < std::numeric_limits<double>::min())
            continue;  // 15 digits say more than these hold
        // The library's shortest may be a digit of 17 shorter, where the nearest of 16 does not
        // lead back but another one does.
        char shortest[40];
        const auto last = std::to_chars(shortest, shortest + sizeof shortest, number,
                                        std::chars_format::scientific)
                              .ptr;
        const auto digitsIn = [](std::string_view any) {
            std::string digits;
            for (const char c : any.substr(0, any.find('e'))) {
                if (c >= '0' && c <= '9' && (c != '0' || !digits.empty())) digits += c;
            }
            while (!digits.empty() && digits.back() == '0') digits.pop_back();
            return digits.size();
        };
        const std::size_t fewest = digitsIn({shortest, static_cast<std::size_t>(last - shortest)});
        ASSERT_LE(digitsIn(text), fewest < 16 ? fewest : 17)
            << text << " " << std::string(shortest, last);
    }
}

TEST(NumberText, IsWrittenAsPeopleDo) {
    EXPECT_EQ(textOf(shortestText(60.0)), "60");
    EXPECT_EQ(textOf(shortestText(-0.0)), "-0");
    EXPECT_EQ(textOf(shortestText(0.1)), "0.1");
    EXPECT_EQ(textOf(shortestText(-1234.5)), "-1234.5");
    EXPECT_EQ(textOf(shortestText(0.0001)), "0.0001");
    EXPECT_EQ(textOf(shortestText(0.00001)), "1e-05");
    EXPECT_EQ(textOf(shortestText(-1.5e-7)), "-1.5e-07");
    EXPECT_EQ(textOf(shortestText(999999999999999.0)), "999999999999999");
    EXPECT_EQ(textOf(shortestText(1e21)), "1e+21");
    EXPECT_EQ(textOf(shortestText(-1.7976931348623157e308)), "-1.7976931348623157e+308");
    EXPECT_EQ(textOf(roundedText(3.14159, 4)), "3.142");
    EXPECT_EQ(textOf(roundedText(0.99996, 4)), "1");
    EXPECT_EQ(textOf(wholeText(std::numeric_limits<std::int64_t>::min())), "-9223372036854775808");
    EXPECT_EQ(textOf(wholeText(0)), "0");
    EXPECT_EQ(textOf(hexText(0xabc, 4)), "0abc");
    EXPECT_EQ(textOf(hexText(~std::uint64_t{0}, 16)), "ffffffffffffffff");
}

TEST(NumberText, RoundsToDecimalsAsPrintfDoes) {
    for (const double number : manyNumbers()) {
        if (!(std::abs(number) < 1e15)) continue;
        for (const int decimals : {0, 1, 2, 3, 6})
            ASSERT_EQ(textOf(fixedText(number, decimals)), printed("%.*f", decimals, number));
    }
    EXPECT_EQ(textOf(fixedText(1e300, 2)), "1e+300");
}

}  // namespace
}  // namespace slicecast
