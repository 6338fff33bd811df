#include "render/light/lit_maps.h"

#include <algorithm>
#include <bit>

namespace slicecast {

void LitMap::beginFrame(const World& world, const Map& map, LightAllowance* allowance) {
    const std::uint32_t before = change_;
    allowance_ = allowance;
    lines_.beginFrame();
    objects_.resize(map.objects.size());
    if (scene_.begin(world, map)) {
        samples_.forgetAll();
        oldest_ = ++change_;
        outside_ = LightSamples::ofOutside(scene_);
    } else if (scene_.changed() != 0) {
        samples_.clear();
        ++change_;
        for (std::size_t bit = 0; bit < changes_.size(); ++bit) {
            if ((scene_.changed() >> bit & 1) != 0) changes_[bit] = change_;
        }
    } else if (isLate_) {
        ++change_;  // so that all is asked for again
    }
    isLate_ = false;
    images_.beginFrame(change_ != before);
}

void LitMap::forgetAll() {
    samples_.forgetAll();
    ++change_;
    records_.clear();
    keys_.clear();
    index_ = HashIndex(kFirstRecordSlots);
    odd_.clear();
    std::fill(recent_.begin(), recent_.end(), Recent{});
    images_.clear();
    lines_.clear();
}

void LitMap::forgetTexels() {
    images_.clear();
    lines_.clear();
}

std::size_t LitMap::bytes() const {
    return records_.size() * (sizeof(Record) + sizeof(std::uint64_t)) + index_.bytes() +
           odd_.size() * sizeof(FaceNodes) + images_.kept() * sizeof(Pixel) +
           lines_.kept() * sizeof(LightLine);
}

bool LitMap::isStale(std::uint64_t touched, std::uint32_t made) const {
    if (made < oldest_) return true;
    for (std::size_t bit = 0; touched != 0; ++bit, touched >>= 1) {
        if ((touched & 1) != 0 && changes_[bit] > made) return true;
    }
    return false;
}

const FaceNodes* LitMap::findNodes(const LitFaceAt& face) {
    if (face.face == LitFace::outside) return &outside_;
    const Record* const record = findRecord(face);
    if (record == nullptr) return nullptr;
    const std::uint64_t key = face.key();
    Recent& recent = recent_[scattered(key) & (recent_.size() - 1)];
    recent = {key, change_, nodesIn(*record)};
    return &recent.nodes;
}

const Pixel* LitMap::makeTexels(LitLevel wanted) {
    const Record* const record = findRecord(wanted.face);
    if (record == nullptr) return images_.make(wanted, outside_, {0, oldest_});
    const auto number = static_cast<std::uint32_t>(record - records_.data()) + 1;
    return images_.make(wanted, nodesIn(*record), {number, record->made});
}

std::uint32_t LitMap::makeLines(LitFaceAt face, int levelBits, const LitFaceAt& instead) {
    const Record* record = face.face == LitFace::outside ? nullptr : findRecord(face);
    if (record == nullptr && face.face != LitFace::outside) {
        face = instead;
        record = findRecord(face);
    }
    const std::uint64_t key = LightLines::keyOf(record != nullptr ? face : kOutside, levelBits);
    return record != nullptr ? lines_.make(key, change_, levelBits, nodesIn(*record), record->made)
                             : lines_.make(key, change_, levelBits, outside_, oldest_);
}

// Makes the light of a face if it is not known. Null if there is no such face.
const LitMap::Record* LitMap::findRecord(const LitFaceAt& face) {
    LitArea area;
    if (!scene_.findArea(face, area)) return nullptr;
    Record& record = recordOf(face.key());
    if (record.made != 0 && !isStale(record.touched, record.made)) return &record;
    const bool isKnown = record.made != 0;
    const bool isMade = worksOut(isKnown, [&] { makeRecord(face, area, record); });
    if (!isMade && !isKnown) keep(LightSamples::ofAmbient(scene_), record);
    return &record;
}

// Works something out, if the picture's allowance is not used up. `isKnown`: as it was before.
template <typename Make>
bool LitMap::worksOut(bool isKnown, Make&& make) {
    if (allowance_ == nullptr) {
        make();
        return true;
    }
    if (allowance_->left <= 0) {
        ++allowance_->late;
        if (!isKnown) ++allowance_->unlit;
        isLate_ = true;
        return false;
    }
    const LightWork before = scene_.work();
    make();
    allowance_->left -= scene_.work() - before;
    return true;
}

// Finds or adds a record; `made` of a new one is 0.
LitMap::Record& LitMap::recordOf(std::uint64_t key) {
    const std::uint32_t hash = scattered(key);
    const std::uint32_t known = index_.find(hash, [&](std::uint32_t i) { return keys_[i] == key; });
    if (known != HashIndex::kNone) return records_[known];
    index_.add(hash);
    keys_.push_back(key);
    records_.emplace_back();
    return records_.back();
}

void LitMap::makeRecord(const LitFaceAt& face, const LitArea& area, Record& record) {
    scene_.clearTouched();
    const FaceNodes nodes = samples_.nodesOf(scene_, face, area);
    record.touched = scene_.touched();
    record.made = change_;
    keep(nodes, record);
}

void LitMap::keep(const FaceNodes& nodes, Record& record) {
    const auto indexIn = [](const Record& r) {
        return static_cast<std::size_t>(r.nodes[0] | r.nodes[1] << 8 | r.nodes[2] << 16);
    };
    const std::size_t place = record.odd != 0 ? indexIn(record) : odd_.size();
    record.odd = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            const Colour node =
                toColour(nodes.nodes[FaceNodes::index(a / 2, b / 2, a - a / 2, b - b / 2)]);
            const auto first = static_cast<std::size_t>(3 * (3 * a + b));
            record.nodes[first] = node.r;
            record.nodes[first + 1] = node.g;
            record.nodes[first + 2] = node.b;
        }
    }
    if (nodesIn(record).nodes == nodes.nodes) return;
    record.odd = 1;
    if (place == odd_.size()) odd_.emplace_back();
    odd_[place] = nodes;
    for (std::size_t i = 0; i < 3; ++i)
        record.nodes[i] = static_cast<std::uint8_t>(place >> (8 * i));
}

FaceNodes LitMap::nodesIn(const Record& record) const {
    const auto& nodes = record.nodes;
    if (record.odd != 0)
        return odd_[static_cast<std::size_t>(nodes[0] | nodes[1] << 8 | nodes[2] << 16)];
    FaceNodes all;
    for (int i = 0; i < 16; ++i) {
        const int a = (i >> 3 & 1) + (i >> 1 & 1);
        const int b = (i >> 2 & 1) + (i & 1);
        const auto first = static_cast<std::size_t>(3 * (3 * a + b));
        all.nodes[static_cast<std::size_t>(i)] =
            toPixel({nodes[first], nodes[first + 1], nodes[first + 2], 255});
    }
    return all;
}

const LightColour& LitMap::ofObject(int index) {
    const auto i = static_cast<std::size_t>(index);
    const Object& object = scene_.map().objects[i];
    LitObject& lit = objects_[i];
    if (lit.made != 0 && lit.x == object.x && lit.y == object.y && lit.z == object.z &&
        !isStale(lit.touched, lit.made))
        return lit.light;
    const bool isMade = worksOut(lit.made != 0, [&] {
        scene_.clearTouched();
        lit.light = LightSamples::ofObject(scene_, object);
        lit.touched = scene_.touched();
        lit.made = change_;
        lit.x = object.x;
        lit.y = object.y;
        lit.z = object.z;
    });
    if (!isMade && lit.made == 0) {
        const Colour ambient = toColour(LightSamples::ofAmbient(scene_).middle());
        lit.light = {ambient.r, ambient.g, ambient.b};
    }
    return lit.light;
}

void LitMaps::beginFrame(const World& world, const RenderOptions& options) {
    world_ = &world;
    on_ = options.baked;
    allowed_ = options.lightWork;
    allowance_ = {allowed_};
    maps_.resize(world.maps.size());
    const auto lit = static_cast<std::size_t>(std::count_if(
        world.maps.begin(), world.maps.end(), [](const Map& map) { return map.baked.on; }));
    sharing_ = std::bit_ceil(std::max<std::size_t>(lit / kFastLitMaps, 1));
    for (Entry& entry : maps_) entry.hasBegun = false;
}

std::size_t LitMaps::bytes() const {
    std::size_t sum = 0;
    for (const Entry& entry : maps_) {
        if (entry.map != nullptr) sum += entry.map->bytes() + entry.map->overhead();
    }
    return sum;
}

// First the light of maps that this frame has not shown yet, then lit texels, then all.
void LitMaps::beginStrip() {
    if (bytes() <= kMostLightKept) return;
    for (Entry& entry : maps_) {
        if (!entry.hasBegun) entry.map.reset();
    }
    for (int all = 0; all < 2 && bytes() > kMostLightKept / 2; ++all) {
        for (Entry& entry : maps_) {
            if (entry.map == nullptr) continue;
            if (all == 0)
                entry.map->forgetTexels();
            else
                entry.map->forgetAll();
        }
    }
}

void LitMaps::begin(int map, Entry& entry) {
    const Map& grid = world_->maps[static_cast<std::size_t>(map)];
    entry.hasBegun = true;
    entry.on = on_ && grid.baked.on;
    if (!entry.on) return;
    if (entry.map == nullptr) entry.map = std::make_unique<LitMap>(sharing_);
    entry.map->beginFrame(*world_, grid, &allowance_);
}

}  // namespace slicecast
