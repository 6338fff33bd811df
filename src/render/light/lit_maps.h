// The baked light of the maps that a picture shows. A face's light is worked out when it is first
// drawn, and kept until something on the ways of its light rays changes.
#pragma once

#include "base/hash_index.h"
#include "render/light/light_lines.h"
#include "render/light/light_samples.h"
#include "render/light/light_scene.h"
#include "render/light/lit_images.h"
#include "world/world.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

// What a picture may still work out of light.
struct LightAllowance {
    LightWork left = kAllLight;
    std::int64_t late = 0;   // see FrameReport::lateLight
    std::int64_t unlit = 0;  // see FrameReport::unlit
};

// Of the maps that have baked light, so many are kept with all that speeds it up.
inline constexpr std::size_t kFastLitMaps = 4;
// What is kept of the light of all maps, bytes: more is given back between strips.
inline constexpr std::size_t kMostLightKept = 32u << 20;

// The light of one map.
class LitMap {
public:
    // What speeds light up takes 1.2 MB, or that divided by `sharing`, a power of two up to 128.
    explicit LitMap(std::size_t sharing = 1)
        : scene_(sharing),
          samples_(sharing),
          index_(kFirstRecordSlots),
          recent_(kRecent / sharing) {}

    // Once before each frame. `allowance` is what is left of the picture's work of light, or null
    // for no limit; it must outlive the frame. If the map is not as it was, its light is shown as
    // it was until it is worked out anew.
    void beginFrame(const World& world, const Map& map, LightAllowance* allowance = nullptr);

    // Between strips: gives back what is kept, as far as nothing holds it.
    void forgetTexels();
    void forgetAll();

    // The nodes of a face; null if there is no such face. Valid until the next call.
    const FaceNodes* nodesOf(const LitFaceAt& face) {
        const std::uint64_t key = face.key();
        const Recent& recent = recent_[scattered(key) & (recent_.size() - 1)];
        return recent.key == key && recent.change == change_ ? &recent.nodes : findNodes(face);
    }

    // The lit texels of a level on a side: see LitImages::find. Valid until the next call of
    // makeTexels.
    const Pixel* knownTexels(const LitLevel& wanted) const { return images_.find(wanted); }
    // Those that are not known yet; those of kOutside if there is no such face. By value, or what
    // is wanted would have to be in memory also where the texels are known.
    const Pixel* makeTexels(LitLevel wanted);

    // The index in allLines() of a face's first line, for texels of a level of that many bits; if
    // there is no such face, of that of `instead`, or else of kOutside. Valid until the next frame.
    std::uint32_t linesOf(const LitFaceAt& face, int levelBits, const LitFaceAt& instead) {
        const std::uint32_t known = lines_.find(LightLines::keyOf(face, levelBits), change_);
        return known != LightLines::kNone ? known : makeLines(face, levelBits, instead);
    }
    const LightLine* allLines() const { return lines_.all(); }

    // Of an object: 0 to 256 for each channel.
    const LightColour& ofObject(int index);

    // Faces whose light is kept, and the bytes of that and of their lit texels.
    std::size_t faces() const { return records_.size(); }
    std::size_t bytes() const;
    // What speeds light up, bytes.
    std::size_t overhead() const {
        return scene_.bytes() + samples_.bytes() + recent_.size() * sizeof(Recent);
    }

private:
    // The light of a face. Nodes that all of its squares share are kept once: 3 x 3 of them.
    // Otherwise `odd` is set and an index stands in their place.
    struct Record {
        std::uint64_t touched = 0;  // see LightScene::touched
        std::uint32_t made = 0;     // at which change
        std::uint8_t odd = 0;
        std::array<std::uint8_t, 27> nodes{};
    };
    static_assert(sizeof(Record) == 40);

    // Nodes that have been asked for lately; faces share places.
    struct Recent {
        std::uint64_t key = 0;
        std::uint32_t change = 0;
        FaceNodes nodes;
    };
    // Powers of two.
    static constexpr std::size_t kRecent = 4096;
    static constexpr std::size_t kFirstRecordSlots = 512;

    struct LitObject {
        std::uint64_t touched = 0;
        std::uint32_t made = 0;  // 0: not known
        Coordinate x;
        Coordinate y;
        Coordinate z;
        LightColour light{};
    };

    bool isStale(std::uint64_t touched, std::uint32_t made) const;
    template <typename Make>
    bool worksOut(bool isKnown, Make&& make);
    const FaceNodes* findNodes(const LitFaceAt& face);
    const Record* findRecord(const LitFaceAt& face);
    Record& recordOf(std::uint64_t key);
    void makeRecord(const LitFaceAt& face, const LitArea& area, Record& record);
    void keep(const FaceNodes& nodes, Record& record);
    FaceNodes nodesIn(const Record& record) const;
    std::uint32_t makeLines(LitFaceAt face, int levelBits, const LitFaceAt& instead);

    LightScene scene_;
    LightSamples samples_;
    LightAllowance* allowance_ = nullptr;
    bool isLate_ = false;       // something is not as it should be since the last frame
    std::uint32_t change_ = 0;  // counts what has changed
    std::uint32_t oldest_ = 0;  // the change at which the whole map did
    std::array<std::uint32_t, 64> changes_{};  // by place bit: the last change there

    std::vector<Record> records_;
    std::vector<std::uint64_t> keys_;  // of the records' faces
    HashIndex index_;                  // of the records, by key
    std::vector<FaceNodes> odd_;
    std::vector<Recent> recent_;
    std::vector<LitObject> objects_;
    FaceNodes outside_;
    LitImages images_;
    LightLines lines_;
};

// The maps of a world with baked light; what is known is kept from frame to frame.
class LitMaps {
public:
    // The world must outlive the frame.
    void beginFrame(const World& world, const RenderOptions& options);

    // Once before each strip: keeps to kMostLightKept, whatever the pictures before have shown.
    void beginStrip();

    // What is kept.
    std::size_t bytes() const;

    // Of this frame; see FrameReport.
    LightWork work() const { return allowed_ - allowance_.left; }
    const LightAllowance& allowance() const { return allowance_; }

    // Null if the map has no baked light.
    LitMap* of(int map) {
        Entry& entry = maps_[static_cast<std::size_t>(map)];
        if (!entry.hasBegun) begin(map, entry);
        return entry.on ? entry.map.get() : nullptr;
    }

    // Room for lit texels, until the next call.
    Pixel* scratch(std::size_t texels) {
        if (scratch_.size() < texels) scratch_.resize(texels);
        return scratch_.data();
    }

private:
    // Maps begin when they are first seen in a frame: most of a world's never are.
    struct Entry {
        std::unique_ptr<LitMap> map;
        bool hasBegun = false;  // this frame
        bool on = false;
    };
    void begin(int map, Entry& entry);

    const World* world_ = nullptr;
    bool on_ = false;
    std::size_t sharing_ = 1;  // see LitMap
    LightWork allowed_ = kAllLight;
    LightAllowance allowance_;
    std::vector<Entry> maps_;
    std::vector<Pixel> scratch_;
};

}  // namespace slicecast
