// The light of faces and objects: samples, and the nodes between which texels are lit. See "Baked
// light" in web/docs/picture.md.
//
//     nodes of a face          its quarters: a sample in each
//
//     *-----*-----*            +--+--+--+--+
//     |     |     |            | 3| 2| 3| 2|
//     |     |     |            +--+--+--+--+      the number says by how many quarter
//     *-----*-----*            | 0| 1| 0| 1|      turns its ways to the sky are turned
//     |     |     |            +--+--+--+--+
//     |     |     |            | 3| 2| 3| 2|
//     *-----*-----*            +--+--+--+--+
//                    b         | 0| 1| 0| 1|
//                    ^ > a     +--+--+--+--+
#pragma once

#include "render/light/light_fans.h"
#include "render/light/light_scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

using LightColour = std::array<std::int32_t, 3>;  // red, green, blue

// The four nodes of each of a face's squares, opaque colours:
// [square along a][square along b][node along a][node along b].
struct FaceNodes {
    std::array<Pixel, 16> nodes{};

    // Where a texture of a single texel is lit.
    Pixel middle() const { return nodes[index(1, 1, 0, 0)]; }

    static constexpr std::size_t index(int squareA, int squareB, int nodeA, int nodeB) {
        return static_cast<std::size_t>(squareA << 3 | squareB << 2 | nodeA << 1 | nodeB);
    }
};

class LightSamples {
public:
    // `sharing`: see LitMap.
    explicit LightSamples(std::size_t sharing = 1) : fans_(sharing), entries_(kEntries / sharing) {}

    // What is kept, bytes.
    std::size_t bytes() const { return fans_.bytes() + entries_.size() * sizeof(Entry); }

    // Forgets all samples.
    void clear() { generation_ += 1; }
    // And what is known of ways: for another map, or if a still block has changed.
    void forgetAll() {
        clear();
        fans_.forget();
    }

    FaceNodes nodesOf(LightScene& scene, const LitFaceAt& face, const LitArea& area);

    // Of the floor outside the grid.
    static FaceNodes ofOutside(const LightScene& scene);
    // Of what no sample shows: the ambient light that is everywhere.
    static FaceNodes ofAmbient(const LightScene& scene);
    // 0 to 256 for each channel.
    static LightColour ofObject(LightScene& scene, const Object& object);

private:
    struct Quarter {
        LightVector at{};
        LightColour light{};
        bool known = false;
        bool counts = false;
        bool isInOpen = false;  // see LightScene::isOpen
    };
    // Of one face; faces share places, and the last one stays.
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t generation = 0;
        bool exists = false;
        LitArea area;
        bool isSeen = false;  // `ways` is known
        LightFans::Face ways;
        std::uint64_t touched = 0;
        std::array<Quarter, 16> quarters;
    };
    static constexpr std::size_t kEntries = 1024;  // a power of two

    Entry& entryOf(LightScene& scene, const LitFaceAt& face);
    const Quarter& quarterOf(LightScene& scene, const LitFaceAt& face, Entry& entry,
                             std::size_t number);
    // Whether light comes from one of the samples of a plane to the other.
    static bool areLinked(LightScene& scene, const LitArea& area, const Quarter& a,
                          const Quarter& b);

    LightFans fans_;
    std::vector<Entry> entries_;
    std::uint32_t generation_ = 1;
};

}  // namespace slicecast
