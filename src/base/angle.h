// Sine, cosine, tangent and arc tangent in degrees, with the same bits from every compiler and on
// every machine.
//
// The libraries' own functions differ in the last bit from one libc to the next, so these use only
// + - * / and the exact fmod. Angles are reduced to a quadrant first: a turn by 90 degrees swaps
// and negates sine and cosine exactly, quarter turns give exactly 0 and +-1, and sine and cosine of
// 45 degrees are the same number. Error below 3e-16 in sine and cosine.
#pragma once

namespace slicecast {

struct SineCosine {
    double sine;
    double cosine;
};

// Any finite angle in degrees.
SineCosine sineCosineDegrees(double degrees);

double sinDegrees(double degrees);
double cosDegrees(double degrees);

// Angles for which the cosine is not 0.
double tanDegrees(double degrees);

// The angle in degrees, in [-90, 90], whose tangent is `slope`.
double atanDegrees(double slope);

// The same heading in [0, 360).
double wrapDegrees(double degrees);

}  // namespace slicecast
