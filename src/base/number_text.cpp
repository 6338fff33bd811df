#include "base/number_text.h"

#include "base/bits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

constexpr int kMostDigits =
    800;  // every double has fewer, and so has every border between two of them
constexpr int kFewDigits = 40;  // enough for all numbers but those that lie next to a border
constexpr int kMostShift = 59;  // ten times a number of so many bits fits into 64

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

// A decimal, not negative: 0.d0 d1 d2 ... * 10^point, without zeros at the end. It is exact unless
// it has more digits than are kept.
struct Decimal {
    std::uint8_t digits[kMostDigits];
    int kept = kMostDigits;
    int count = 0;
    int point = 0;
    bool isMore = false;  // than these digits say

    void add(int digit) {
        if (count < kept) {
            digits[count++] = static_cast<std::uint8_t>(digit);
        } else {
            isMore = isMore || digit != 0;
        }
    }
    char character(int at) const {
        return static_cast<char>('0' + (at >= 0 && at < count ? digits[at] : 0));
    }
    void trim() {
        while (count > 0 && digits[count - 1] == 0) --count;
        if (count == 0) point = 0;
    }

    void setWhole(std::uint64_t number);
    void shift(int bits);
    void roundTo(int wanted);
    std::uint64_t rounded() const;
    std::optional<double> value(int keptDigits) const;

private:
    void shiftLeft(int bits);
    void shiftRight(int bits);
    bool roundsUp(int at) const;
    bool isDoubtful(int at) const;
};

void Decimal::setWhole(std::uint64_t number) {
    int length = 0;
    for (std::uint64_t rest = number; rest != 0; rest /= 10) ++length;
    count = point = length;
    for (std::uint64_t rest = number; rest != 0; rest /= 10)
        digits[--length] = static_cast<std::uint8_t>(rest % 10);
    trim();
}

// Times 2^bits.
void Decimal::shift(int bits) {
    for (; bits > 0; bits -= std::min(bits, kMostShift)) shiftLeft(std::min(bits, kMostShift));
    for (; bits < 0; bits += std::min(-bits, kMostShift)) shiftRight(std::min(-bits, kMostShift));
}

void Decimal::shiftLeft(int bits) {
    constexpr int kLongest = kMostDigits + 20;
    std::uint8_t longer[kLongest];  // filled from its end
    int first = kLongest;
    std::uint64_t carry = 0;
    for (int i = count; i > 0 || carry != 0; carry /= 10) {
        if (i > 0) carry += static_cast<std::uint64_t>(digits[--i]) << bits;
        longer[--first] = static_cast<std::uint8_t>(carry % 10);
    }
    const int length = kLongest - first;
    point += length - count;
    count = 0;
    for (int i = 0; i < length; ++i) add(longer[first + i]);
    trim();
}

void Decimal::shiftRight(int bits) {
    const int length = count;
    std::uint64_t rest = 0;
    int read = 0;
    // What is left of the first digits, until they make a whole number
    for (; rest >> bits == 0; ++read) {
        if (read >= length && rest == 0) return;  // zero
        rest = 10 * rest + (read < length ? digits[read] : 0u);
    }
    point -= read - 1;
    count = 0;
    for (;; ++read) {
        // The digit is written behind those that have been read, since the first of them took at
        // least one.
        add(static_cast<int>(rest >> bits));
        rest &= (std::uint64_t{1} << bits) - 1;
        if (read >= length && rest == 0) break;
        if (count == kept) {
            isMore = true;
            break;
        }
        rest = 10 * rest + (read < length ? digits[read] : 0u);
    }
    trim();
}

bool Decimal::roundsUp(int at) const {
    if (at < 0 || at >= count) return false;
    if (digits[at] == 5 && at + 1 == count && !isMore) return at > 0 && digits[at - 1] % 2 == 1;
    return digits[at] >= 5;
}

// Rounds to at most `wanted` digits.
void Decimal::roundTo(int wanted) {
    if (wanted >= count) return;
    const bool up = roundsUp(wanted);
    count = std::max(0, wanted);
    isMore = false;
    if (up) {
        while (count > 0 && digits[count - 1] == 9) --count;
        if (count > 0) {
            ++digits[count - 1];
        } else {
            digits[count++] = 1;
            ++point;
        }
    }
    trim();
}

// As a whole number, which fits.
std::uint64_t Decimal::rounded() const {
    std::uint64_t whole = 0;
    for (int i = 0; i < point; ++i) whole = 10 * whole + (i < count ? digits[i] : 0u);
    return whole + (roundsUp(point) ? 1 : 0);
}

// Whether roundsUp might be wrong because digits have been left out: they make up less than 1e-19
// of a whole one in all steps of value().
bool Decimal::isDoubtful(int at) const {
    if (!isMore || at < 0 || at + 19 > count || digits[at] != 4) return false;
    return std::all_of(digits + at + 1, digits + at + 19,
                       [](std::uint8_t digit) { return digit == 9; });
}

// The nearest double, worked out with this many digits; nothing if they are too few to tell.
std::optional<double> Decimal::value(int keptDigits) const {
    if (count == 0 || point < -400) return 0.0;
    if (point > 400) return HUGE_VAL;
    // Halved and doubled until it lies between 1/2 and 1; three halvings never lose a whole digit.
    Decimal scaled;
    scaled.kept = keptDigits;
    scaled.point = point;
    scaled.isMore = isMore;
    for (int i = 0; i < count; ++i) scaled.add(digits[i]);
    scaled.trim();
    int exponent = 0;
    const auto by = [&](int bits) {
        scaled.shift(bits);
        exponent -= bits;
    };
    while (scaled.point > 0) by(-std::min(kMostShift, 3 * scaled.point + 1));
    while (scaled.point < 0) by(std::min(kMostShift, -3 * scaled.point));
    while (scaled.digits[0] < 5) by(1);
    // 53 bits of it, fewer of the smallest numbers
    const int bits = std::clamp(exponent + 1074, 0, 53);
    scaled.shift(bits);
    if (keptDigits < kMostDigits && scaled.isDoubtful(scaled.point)) return std::nullopt;
    return std::ldexp(static_cast<double>(scaled.rounded()), exponent - bits);
}

Decimal decimalOf(double number) {
    constexpr std::uint64_t kHidden = std::uint64_t{1} << 52;
    const auto bits = bitCast<std::uint64_t>(number);
    const int exponent = static_cast<int>(bits >> 52 & 2047);
    Decimal decimal;
    decimal.setWhole((bits & (kHidden - 1)) | (exponent > 0 ? kHidden : 0));
    decimal.shift(std::max(exponent, 1) - 1075);
    return decimal;
}

void addWhole(NumberText& text, std::uint64_t number) {
    if (number >= 10) addWhole(text, number / 10);
    text.add(static_cast<char>('0' + number % 10));
}

// With an exponent where there would be many zeros.
NumberText written(bool isNegative, const Decimal& decimal) {
    NumberText text;
    if (isNegative) text.add('-');
    const bool hasExponent = decimal.point > 15 || decimal.point < -3;
    const int point = hasExponent ? 1 : decimal.point;
    for (int i = std::min(0, point - 1); i < std::max(point, decimal.count); ++i) {
        if (i == point) text.add('.');
        text.add(decimal.character(i));
    }
    if (hasExponent) {
        const int exponent = decimal.point - 1;
        text.add('e');
        text.add(exponent < 0 ? '-' : '+');
        if (std::abs(exponent) < 10) text.add('0');
        addWhole(text, static_cast<std::uint64_t>(std::abs(exponent)));
    }
    return text;
}

}  // namespace

NumberText wholeText(std::int64_t number) {
    NumberText text;
    if (number < 0) text.add('-');
    addWhole(text, number < 0 ? 0 - static_cast<std::uint64_t>(number)
                              : static_cast<std::uint64_t>(number));
    return text;
}

NumberText hexText(std::uint64_t number, int digits) {
    NumberText text;
    while (digits-- > 0) text.add("0123456789abcdef"[number >> 4 * digits & 15]);
    return text;
}

NumberText roundedText(double number, int digits) {
    Decimal decimal = decimalOf(number);
    decimal.roundTo(digits);
    return written(std::signbit(number), decimal);
}

NumberText shortestText(double number) {
    if (std::abs(number) < 1e15 && number == std::floor(number) &&
        !(number == 0.0 && std::signbit(number)))
        return wholeText(static_cast<std::int64_t>(number));
    const Decimal exact = decimalOf(number);
    for (int digits = 15;; ++digits) {
        Decimal decimal = exact;
        decimal.roundTo(digits);
        const NumberText text = written(std::signbit(number), decimal);
        if (digits == 17 || readNumber(text) == number) return text;
    }
}

NumberText fixedText(double number, int decimals) {
    if (!(std::abs(number) < 1e15)) return shortestText(number);
    Decimal decimal = decimalOf(number);
    decimal.roundTo(decimal.point + decimals);
    NumberText text;
    if (std::signbit(number)) text.add('-');
    for (int i = std::min(0, decimal.point - 1); i < decimal.point + decimals; ++i) {
        if (i == decimal.point) text.add('.');
        text.add(decimal.character(i));
    }
    return text;
}

std::optional<double> readNumber(std::string_view text) {
    std::size_t at = 0;
    const auto next = [&](char wanted) {
        return at < text.size() && (text[at] == wanted || (wanted == 'e' && text[at] == 'E')) &&
               ++at > 0;
    };
    const bool isNegative = next('-');
    if (!isNegative) next('+');

    Decimal decimal;
    bool hasDigits = false;
    bool hasPoint = false;
    for (; at < text.size() && (isDigit(text[at]) || (text[at] == '.' && !hasPoint)); ++at) {
        if (text[at] == '.') {
            hasPoint = true;
            continue;
        }
        hasDigits = true;
        if (decimal.count > 0 || text[at] != '0') {
            decimal.add(text[at] - '0');
            if (!hasPoint) ++decimal.point;
        } else if (hasPoint) {
            --decimal.point;
        }
    }
    if (!hasDigits) return std::nullopt;

    if (next('e')) {
        const bool isSmall = next('-');
        if (!isSmall) next('+');
        if (at == text.size()) return std::nullopt;
        std::int64_t exponent =
            0;  // no text is long enough to make up for more than a thousand million
        for (; at < text.size() && isDigit(text[at]); ++at)
            exponent = std::min<std::int64_t>(1'000'000'000, 10 * exponent + (text[at] - '0'));
        decimal.point += static_cast<int>(isSmall ? -exponent : exponent);
    }
    if (at != text.size()) return std::nullopt;
    decimal.trim();

    // Up to 15 digits and the powers of ten up to 22 are numbers themselves: one rounding is all
    // that happens.
    double value;
    const int power = decimal.point - decimal.count;
    if (!decimal.isMore && decimal.count <= 15 && std::abs(power) <= 22) {
        value = 0.0;
        for (int i = 0; i < decimal.count; ++i) value = 10.0 * value + decimal.digits[i];
        double tens = 1.0;
        for (int i = 0; i < std::abs(power); ++i) tens *= 10.0;
        value = power < 0 ? value / tens : value * tens;
    } else {
        const std::optional<double> quick = decimal.value(kFewDigits);
        value = quick ? *quick : *decimal.value(kMostDigits);
    }
    return isNegative ? -value : value;
}

}  // namespace slicecast
