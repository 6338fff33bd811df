// A texture cut into pieces: bricks, stones, tiles, leaves of a floor. For every texel the piece
// that it belongs to and its distance to the nearest other piece, from which joints, bevels and
// domes are shaped.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "picture.h"

namespace slicecast::textures {

inline constexpr int kEdgeReach = 9;  // distances beyond this are reported as this

class Pieces {
public:
    // `pieceOf` names the piece at a place. `unevenness` bends the cuts by up to that many texels.
    // For a picture of kFineSide texels `fineness` is kFine: then places are in its texels,
    // distances still in those of others.
    Pieces(const std::function<int(double x, double y)>& pieceOf, double unevenness,
           std::uint32_t seed, int fineness = 1);

    int pieceAt(int x, int y) const { return pieces_[indexOf(x, y)]; }
    double edgeAt(int x, int y) const { return edges_[indexOf(x, y)]; }  // texels, at least 0.5

private:
    std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(wrap(y, side_)) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(wrap(x, side_));
    }

    int side_;
    std::vector<int> pieces_;
    std::vector<double> edges_;
};

// One row of blocks, `height` texels tall; the first block starts at `offset`; widths add up to
// kSide.
struct Course {
    int height;
    int offset;
    std::vector<int> widths;
};

// Courses from top to bottom; heights add up to kSide. Pieces are numbered 16 * course + block.
std::function<int(double, double)> coursed(std::vector<Course> courses);

// A pattern drawn with letters on a coarse square grid; equal neighbouring letters are one piece.
std::function<int(double, double)> lettered(std::vector<std::string> rows);

struct Point {
    double x;
    double y;
};

// Points spread evenly and irregularly over the texture. `flatness` above 1 makes their regions
// wider than tall.
std::vector<Point> spreadPoints(int count, double flatness, std::uint32_t seed);

// Each texel belongs to the nearest point.
std::function<int(double, double)> nearest(std::vector<Point> points, double flatness);

// The shorter way from one coordinate to another around the texture, in (-64, 64].
double wrappedDifference(double from, double to);

}  // namespace slicecast::textures
