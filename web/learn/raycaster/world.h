// The shapes that raycaster.cpp is given and makes; JavaScript needs no declarations of them. A
// world is read from a file of doubles, which world-numbers.js writes.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

// ---- what it is given

using Colour = std::array<int, 4>;  // red, green, blue, alpha: 0 to 255

enum Face : int { north, east, south, west, top, bottom, none };

struct Level {
    int width, height;
    std::vector<Colour> texels;  // row by row
};

using Texture = std::vector<Level>;  // levels of detail

struct Look {     // of a face, a floor, a ceiling
    int texture;  // -1 for none
    double light;
    int mirror;  // strength, 0 to 255
};

struct Motion {
    int moves;  // 0: nothing, 1: the top, 2: the bottom, 3: both
    double from, to, period, phase;
    int shape;  // 0: smooth, 1: even, 2: stop-and-go
    double bottom, top;
};

struct Block {
    double bottom, top;
    bool seeThrough, join;
    std::array<Look, 6> faces;
    Motion motion;
    double moved;
};

struct Object {
    int texture;
    double x, y, z, width, height, light;
};

struct Portal {
    int x, y, level, face, toMap, toX, toY, toLevel, turn;
};

struct Map {
    int width, depth, levels;
    std::vector<Block> blocks;
    std::vector<int> cells;            // [(level * depth + y) * width + x], -1 for none
    std::vector<Look> floor, ceiling;  // [y * width + x]
    Look outside;                      // the floor there
    double ceilingHeight, far, skySlope;
    Colour haze, skyLow, skyHigh;
    bool isLit;
    double intensity, multiplier, darkest, brightest;
    bool isFoggy;
    double fogStart, fogEnd;
    std::vector<Object> objects;
    std::vector<Portal> portals;
};

struct World {
    std::vector<Texture> textures;
    std::vector<Map> maps;
    double seconds;
    int portalLimit;
};

struct Eye {
    int map;
    double x, y, z, heading, look, fov;
};

struct Picture {
    int width, height;
    std::vector<std::uint32_t> pixels;  // bytes R, G, B, A
};

// ---- what it makes

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Point {
    double x, y;
};

// What all columns of a picture share. Lengths are in pixels.
struct View {
    double width, distance, horizon, up;
    Point forward, right;
};

// A block in its tile, with its heights above the floor.
struct Placed {
    const Block* block;
    int level;
    double bottom, top;
};

// A tile, the depths where the ray enters and leaves it, and the face through which it enters.
struct Tile {
    int x, y;
    double near = 0.0;
    double far = kInfinity;
    Face face = none;
    std::vector<Placed> blocks = {};
};

struct Plane {
    double height;
    const Look* look;
    bool under;  // seen from below
    int order;   // of planes at one height
};

struct Seen {  // an object that a slice passes
    const Object* object;
    double depth, u;
};

struct Layer {  // what is seen through, in a row
    int row;
    Colour colour;
};

// What all slices of a column share.
struct Column {
    Picture& picture;
    int number;
    std::vector<char> open;
    std::vector<Layer> layers = {};
};

struct Slice {  // what one column sees of one map
    const World& world;
    Column& column;
    const Map* map;
    Eye eye;
    View view;
    Point ray;
    Tile from;        // where the walk begins
    int first, last;  // rows
    double lowest = -kInfinity;
    int portals = 0;
};

// ---- reading

// The numbers of a file, one after the other.
class Numbers {
public:
    explicit Numbers(const std::string& name) {
        std::ifstream file(name, std::ios::binary | std::ios::ate);
        if (!file) return;
        all_.resize(static_cast<std::size_t>(file.tellg()) / sizeof(double));
        file.seekg(0).read(reinterpret_cast<char*>(all_.data()),
                           static_cast<std::streamsize>(all_.size() * sizeof(double)));
    }

    bool isAtEnd() const { return next_ == all_.size(); }

    // Braces read from left to right.
    double real() { return all_.at(next_++); }
    int whole() { return static_cast<int>(real()); }
    bool flag() { return real() != 0.0; }
    Colour colour() { return {whole(), whole(), whole(), whole()}; }
    Look look() { return {whole(), real(), whole()}; }
    Motion motion() { return {whole(), real(), real(), real(), real(), whole(), real(), real()}; }
    Block block() {
        return {real(),   real(), flag(), flag(), {look(), look(), look(), look(), look(), look()},
                motion(), 0.0};
    }
    Object object() { return {whole(), real(), real(), real(), real(), real(), real()}; }
    Portal portal() {
        return {whole(), whole(), whole(), whole(), whole(), whole(), whole(), whole(), whole()};
    }
    Level level() { return {whole(), whole(), list(&Numbers::colour)}; }
    Texture texture() { return list(&Numbers::level); }
    Map map() {
        return {whole(),
                whole(),
                whole(),
                list(&Numbers::block),
                list(&Numbers::whole),
                list(&Numbers::look),
                list(&Numbers::look),
                look(),
                real(),
                real(),
                real(),
                colour(),
                colour(),
                colour(),
                flag(),
                real(),
                real(),
                real(),
                real(),
                flag(),
                real(),
                real(),
                list(&Numbers::object),
                list(&Numbers::portal)};
    }
    World world() { return {list(&Numbers::texture), list(&Numbers::map), real(), whole()}; }
    Eye eye() { return {whole(), real(), real(), real(), real(), real(), real()}; }

private:
    template <typename Thing>
    std::vector<Thing> list(Thing (Numbers::*read)()) {
        std::vector<Thing> things(static_cast<std::size_t>(whole()));
        for (Thing& thing : things) thing = (this->*read)();
        return things;
    }

    std::vector<double> all_;
    std::size_t next_ = 0;
};
