#include "base/angle.h"

#include <cmath>

namespace slicecast {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;
constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr double kSqrtHalf = 0.7071067811865476;

// Taylor series of the sine for |x| <= pi/4; the first term left out is below 1e-18.
double sineSeries(double x) {
    const double q = x * x;
    double sum = 1.0 / 355687428096000.0;  // 1/17!
    sum = sum * q - 1.0 / 1307674368000.0;
    sum = sum * q + 1.0 / 6227020800.0;
    sum = sum * q - 1.0 / 39916800.0;
    sum = sum * q + 1.0 / 362880.0;
    sum = sum * q - 1.0 / 5040.0;
    sum = sum * q + 1.0 / 120.0;
    sum = sum * q - 1.0 / 6.0;
    return x + x * (q * sum);
}

// Taylor series of the cosine for |x| <= pi/4.
double cosineSeries(double x) {
    const double q = x * x;
    double sum = 1.0 / 20922789888000.0;  // 1/16!
    sum = sum * q - 1.0 / 87178291200.0;
    sum = sum * q + 1.0 / 479001600.0;
    sum = sum * q - 1.0 / 3628800.0;
    sum = sum * q + 1.0 / 40320.0;
    sum = sum * q - 1.0 / 720.0;
    sum = sum * q + 1.0 / 24.0;
    sum = sum * q - 0.5;
    return 1.0 + q * sum;
}

// Arc tangent in radians for 0 <= x <= 1: the argument is halved twice by atan(x) = 2 atan(x / (1 +
// sqrt(1 + x^2))), which leaves at most 0.2, then the alternating series.
double arcTangentSeries(double x) {
    double reduced = x;
    for (int i = 0; i < 2; ++i) reduced = reduced / (1.0 + std::sqrt(1.0 + reduced * reduced));
    const double q = reduced * reduced;
    double sum = 0.0;
    for (int n = 25; n >= 1; n -= 2) sum = 1.0 / n - q * sum;
    return 4.0 * reduced * sum;
}

}  // namespace

SineCosine sineCosineDegrees(double degrees) {
    // Within one turn, of either sign: adding 360 to a small negative angle would round it.
    const double turn = std::fmod(degrees, 360.0);
    const int quadrant = static_cast<int>((turn + 405.0) / 90.0) - 4;
    const double rest = turn - 90.0 * quadrant;
    double s;
    double c;
    if (rest == 45.0 || rest == -45.0) {
        s = rest > 0 ? kSqrtHalf : -kSqrtHalf;
        c = kSqrtHalf;
    } else {
        const double x = rest * kRadiansPerDegree;
        s = sineSeries(x);
        c = cosineSeries(x);
    }
    switch (quadrant & 3) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};  // 3, or -1
    }
}

double sinDegrees(double degrees) {
    return sineCosineDegrees(degrees).sine;
}

double cosDegrees(double degrees) {
    return sineCosineDegrees(degrees).cosine;
}

double tanDegrees(double degrees) {
    const SineCosine both = sineCosineDegrees(degrees);
    return both.sine / both.cosine;
}

double atanDegrees(double slope) {
    const double size = slope < 0 ? -slope : slope;
    double degrees;
    if (size == 1.0) {
        degrees = 45.0;
    } else if (size < 1.0) {
        degrees = arcTangentSeries(size) * kDegreesPerRadian;
    } else {
        degrees = 90.0 - arcTangentSeries(1.0 / size) * kDegreesPerRadian;
    }
    return slope < 0 ? -degrees : degrees;
}

double wrapDegrees(double degrees) {
    double wrapped = std::fmod(degrees, 360.0);
    if (wrapped < 0) wrapped += 360.0;
    return wrapped >= 360.0 ? 0.0 : wrapped;
}

}  // namespace slicecast
