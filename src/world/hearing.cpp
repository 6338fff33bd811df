#include "world/hearing.h"

#include "base/angle.h"
#include "world/water.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

constexpr double kStanding = 0.2;     // units per second: slower is no walk
constexpr double kFirstStride = 0.5;  // whoever starts to walk sets down a foot soon
constexpr double kHeardJump = 1.0;    // units per second, upward
constexpr double kHeardFall = 1.0;    // units per second, downward
constexpr double kLoudestFall = 8.0;  // units per second
constexpr double kQuietStep = 0.25;   // gains
constexpr double kQuietSplash = 0.3;
constexpr double kStrokeGain = 0.5;
constexpr double kStepBySpeed = 0.1;  // gain, times the speed
constexpr double kQuietMover = 0.3;   // gain when it just moves; at a unit per second it is 1
constexpr int kShelter = 2;           // tiles: how far around a wall keeps the wind away
constexpr double kCalm = 0.3;         // part of the wind that is there at the ground

double within01(double value) {
    return std::min(std::max(value, 0.0), 1.0);
}

const Map& mapOf(const World& world, const Player& player) {
    return world.maps[static_cast<std::size_t>(player.map)];
}

// ---- Materials

Material materialOf(const World& world, TextureId texture) {
    return texture < world.textures.size() ? world.textures[texture].material : Material::stone;
}

Material sideOf(const World& world, BlueprintId blueprint) {
    return materialOf(world, world.blueprints[blueprint].face(Face::north).texture);
}

// What lies under the feet: the block below the middle of the body, else another one below it, else
// the floor.
Material groundUnder(const World& world, const Player& player) {
    if (waterDepth(world, travellerOf(player)).raw > 0) return Material::water;
    const Map& map = mapOf(world, player);
    const Box body = bodyBox(player);
    const int level = Coordinate{player.z.raw - 1}.tile();
    const int middleX = player.x.tile();
    const int middleY = player.y.tile();
    const auto blockAt = [&](int x, int y) {
        const BlueprintId cell = map.cell(x, y, level);
        return world.blueprints[cell].isWater ? kEmptyCell : cell;
    };
    BlueprintId block = blockAt(middleX, middleY);
    for (int y = body.north.tile(); y <= Coordinate{body.south.raw - 1}.tile(); ++y) {
        for (int x = body.west.tile(); x <= Coordinate{body.east.raw - 1}.tile(); ++x) {
            if (block == kEmptyCell) block = blockAt(x, y);
        }
    }
    if (block != kEmptyCell)
        return materialOf(world, world.blueprints[block].face(Face::top).texture);
    // Whoever stands is within the grid.
    const bool isOnCeiling = player.z.raw > 0 && !map.ceiling.tiles.empty();
    const std::vector<TextureId>& tiles = isOnCeiling ? map.ceiling.tiles : map.floor.tiles;
    return materialOf(world, tiles[map.tileIndex(middleX, middleY)]);
}

// ---- Places

// Where the ears are, and where right is.
class Ears {
public:
    explicit Ears(const Player& player)
        : place_{player.x, player.y, eyeHeight(player)},
          ahead_(sineCosineDegrees(player.headingDegrees)) {}

    // How loud and from which side the nearest point of a box is heard. A place nearer than a unit
    // comes from both sides, so that passing it does not leap from ear to ear.
    Sound from(const Box& box, double earshot) const {
        const double x = wayTo(place_.x, box.west, box.east);
        const double y = wayTo(place_.y, box.north, box.south);
        const double z = wayTo(place_.z, box.bottom, box.top);
        const double distance = std::sqrt(x * x + y * y + z * z);
        const double right = y * ahead_.cosine - x * ahead_.sine;
        const double close = within01(1.0 - distance / earshot);
        return {.gain = close * close, .pan = right / std::max(distance, 1.0)};
    }

private:
    static double wayTo(Coordinate from, Coordinate low, Coordinate high) {
        return (std::max(low, std::min(from, high)) - from).value();
    }

    Position place_;
    SineCosine ahead_;
};

// All sources of one kind: as loud as the nearest, from the middle of all.
struct Mixed {
    Material nearest = Material::stone;
    double gain = 0.0;
    double weights = 0.0;
    double pans = 0.0;

    void add(const Sound& sound, Material material) {
        if (sound.gain > gain) {
            gain = sound.gain;
            nearest = material;
        }
        weights += sound.gain;
        pans += sound.gain * sound.pan;
    }
    Sound as(SoundKind kind) const {
        return {kind, nearest, gain, weights > 0.0 ? pans / weights : 0.0};
    }
};

// ---- Gates and movers

// The gates that have moved in the last step: those that have thereby opened or shut, or the
// others.
Mixed movedGates(const World& world, const Player& player, bool areAtEnd) {
    Mixed mixed;
    for (const Gate& gate : world.gates) {
        const int steps = world.gateKinds[static_cast<std::size_t>(gate.kind)].steps;
        const bool isAtEnd = gate.progress == 0 || gate.progress == steps;
        if (gate.map == player.map && gate.progress != gate.previousProgress && isAtEnd == areAtEnd)
            mixed.add(Ears(player).from(gate.bounds, kEarshot), sideOf(world, gate.parts[0]));
    }
    return mixed;
}

Mixed movers(const World& world, const Player& player, const Ears& ears) {
    Mixed mixed;
    for (const Mover& mover : world.movers) {
        const Coordinate way = mover.offset - mover.previousOffset;
        if (mover.map != player.map || way.raw == 0) continue;
        Sound sound = ears.from(boundsOf(world, mover), kEarshot);
        const double speed = std::abs(way.value()) * kStepsPerSecond;
        sound.gain *= std::min(1.0, kQuietMover + (1.0 - kQuietMover) * speed);
        mixed.add(sound, sideOf(world, mover.shafts[0].firstPart));
    }
    return mixed;
}

// ---- Water and wind

Mixed waterAround(const World& world, const Player& player, const Ears& ears) {
    const Map& map = mapOf(world, player);
    constexpr int kReach = static_cast<int>(kWaterEarshot);
    Mixed mixed;
    for (int y = player.y.tile() - kReach; y <= player.y.tile() + kReach; ++y) {
        for (int x = player.x.tile() - kReach; x <= player.x.tile() + kReach; ++x) {
            if (!map.contains(x, y)) continue;
            const auto addSurface = [&, x, y](Coordinate height) {
                mixed.add(ears.from({tileEdge(x), tileEdge(x + 1), tileEdge(y), tileEdge(y + 1),
                                     height, height},
                                    kWaterEarshot),
                          Material::water);
            };
            if (map.isWaterFloor(map.tileIndex(x, y))) addSurface({});
            for (int level = 0; level < map.levels; ++level) {
                const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
                if (block.isWater) addSurface(tileEdge(level) + block.top);
            }
        }
    }
    return mixed;
}

// True if neither a block nor a ceiling reaches above that height in a tile.
bool isOpen(const World& world, const Map& map, int x, int y, Coordinate height) {
    if (!map.contains(x, y)) return true;
    if (!map.ceiling.tiles.empty() && map.ceiling.tiles[map.tileIndex(x, y)] != kNoTexture &&
        map.ceiling.height > height)
        return false;
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId cell = map.cell(x, y, level);
        const CellBlueprint& block = world.blueprints[cell];
        if (cell != kEmptyCell && !block.isWater && tileEdge(level) + block.top > height)
            return false;
    }
    return true;
}

double windAt(const World& world, const Player& player) {
    constexpr int kColumns = 9;
    const Coordinate height = eyeHeight(player);
    int open = 0;
    for (int y = -kShelter; y <= kShelter; y += kShelter) {
        for (int x = -kShelter; x <= kShelter; x += kShelter)
            open += isOpen(world, mapOf(world, player), player.x.tile() + x, player.y.tile() + y,
                           height);
    }
    const double share = static_cast<double>(open) / kColumns;
    return share * share * (kCalm + (1.0 - kCalm) * within01(height.value() / kWindyHeight));
}

bool isSubmerged(const World& world, const Player& player) {
    return waterAt(world, mapOf(world, player), player.x.tile(), player.y.tile(), eyeHeight(player))
               .water != nullptr;
}

}  // namespace

void Hearing::add(const Sound& sound) {
    if (sound.gain > 0.0) heard_[static_cast<std::size_t>(count_++)] = sound;
}

void Hearing::step(const World& world, const Player& before, const Player& now) {
    if (isTaken_) count_ = 0;
    isTaken_ = false;
    // A crossing, a splash, a jump or a landing, a step or a stroke, a knock, a find, the goal
    constexpr int kMostInAStep = 7;
    if (count_ > kMostAtOnce - kMostInAStep) return;
    if (now.leaps != before.leaps) add({.kind = SoundKind::crossing, .gain = 1.0});
    hearFeet(world, before, now);
    add(movedGates(world, now, true).as(SoundKind::knock));
    hearQuest(world);
}

// Two finds at once sound like one.
void Hearing::hearQuest(const World& world) {
    const auto has = [&](QuestNews::Kind kind) {
        const std::vector<QuestNews>& news = world.quest.news;
        return std::any_of(news.begin(), news.end(),
                           [kind](const QuestNews& each) { return each.kind == kind; });
    };
    if (has(QuestNews::Kind::find)) add({.kind = SoundKind::find, .gain = 1.0});
    if (has(QuestNews::Kind::goal)) add({.kind = SoundKind::goal, .gain = 1.0});
}

void Hearing::hearFeet(const World& world, const Player& before, const Player& now) {
    const double fall = within01(-before.velocityZ / kLoudestFall);
    const double speed = std::sqrt(now.velocityX * now.velocityX + now.velocityY * now.velocityY);
    if (now.swimming && !before.swimming)
        add({SoundKind::splash, Material::water, std::max(kQuietSplash, fall), 0.0});
    if (before.onGround && !now.onGround && now.velocityZ > kHeardJump && !now.swimming)
        add({SoundKind::jump, groundUnder(world, before), kQuietStep, 0.0});
    if (now.onGround && !before.onGround && before.velocityZ < -kHeardFall) {
        add({SoundKind::land, groundUnder(world, now), fall, 0.0});
        stride_ = 0.0;
    }
    if (speed < kStanding) stride_ = kFirstStride;
    const bool walks = before.onGround && now.onGround;
    if ((!walks && !now.swimming) || speed < kStanding) return;
    stride_ += speed * kStepSeconds / (now.swimming ? kStroke : kStride + kStrideBySpeed * speed);
    if (stride_ < 1.0) return;
    stride_ -= 1.0;
    if (now.swimming) {
        add({SoundKind::stroke, Material::water, kStrokeGain, 0.0});
    } else {
        add({SoundKind::step, groundUnder(world, now),
             std::min(kQuietStep + kStepBySpeed * speed, 1.0), 0.0});
    }
}

std::span<const Sound> Hearing::take(const World& world, const Player& now) {
    if (isTaken_) count_ = 0;
    isTaken_ = true;
    const Ears ears(now);
    add(movedGates(world, now, false).as(SoundKind::gate));
    add(movers(world, now, ears).as(SoundKind::mover));
    add(waterAround(world, now, ears).as(SoundKind::water));
    add({.kind = SoundKind::wind, .gain = windAt(world, now)});
    add({.kind = SoundKind::submerged, .gain = isSubmerged(world, now) ? 1.0 : 0.0});
    return {heard_.data(), static_cast<std::size_t>(count_)};
}

}  // namespace slicecast
