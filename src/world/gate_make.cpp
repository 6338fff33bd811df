// Finds the gates of a world and gives each blueprints of its own.
#include "base/words.h"
#include "world/gate.h"
#include "world/mover.h"
#include "world/moving_cells.h"
#include "world/world.h"

#include <algorithm>
#include <string>
#include <utility>

namespace slicecast {
namespace {

Box boundsOf(const std::vector<Box>& boxes) {
    Box bounds = boxes.front();
    for (const Box& box : boxes) {
        bounds = {std::min(bounds.west, box.west),     std::max(bounds.east, box.east),
                  std::min(bounds.north, box.north),   std::max(bounds.south, box.south),
                  std::min(bounds.bottom, box.bottom), std::max(bounds.top, box.top)};
    }
    return bounds;
}

Box boxOf(const CellPlace& at, const CellBlueprint& block) {
    return {tileEdge(at.x),
            tileEdge(at.x + 1),
            tileEdge(at.y),
            tileEdge(at.y + 1),
            tileEdge(at.level) + block.bottom,
            tileEdge(at.level) + block.top};
}

Gate makeGate(World& world, int mapIndex, const std::vector<CellPlace>& group) {
    Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    Gate gate;
    gate.map = mapIndex;
    gate.kind = world.blueprints[map.cell(group[0].x, group[0].y, group[0].level)].gate;
    std::vector<std::pair<BlueprintId, BlueprintId>>
        partOf;  // part by its blueprint in the scene's text
    for (const CellPlace& at : group) {
        const BlueprintId id = map.cell(at.x, at.y, at.level);
        auto known = std::find_if(partOf.begin(), partOf.end(),
                                  [id](const auto& pair) { return pair.first == id; });
        if (known == partOf.end()) {
            partOf.emplace_back(id, static_cast<BlueprintId>(world.blueprints.size()));
            known = partOf.end() - 1;
            gate.parts.push_back(known->second);
            CellBlueprint part = instanceOf(world, id);
            part.gateIndex = static_cast<int>(world.gates.size());
            world.blueprints.push_back(std::move(part));
        }
        map.setChangingCell(at.x, at.y, at.level, known->second);
        gate.boxes.push_back(boxOf(at, world.blueprints[known->second]));
    }
    gate.bounds = boundsOf(gate.boxes);
    return gate;
}

// A gate that moves a mover. Its boxes are where the scene's rows have its blocks.
Gate makeMovingGate(World& world, int moverIndex) {
    Mover& mover = world.movers[static_cast<std::size_t>(moverIndex)];
    const Map& map = world.maps[static_cast<std::size_t>(mover.map)];
    const Axis axis = world.motions[static_cast<std::size_t>(mover.motion)].axis;
    mover.gate = static_cast<int>(world.gates.size());
    Gate gate;
    gate.map = mover.map;
    gate.kind = world.blueprints[mover.shafts[0].firstPart].gate;
    gate.mover = moverIndex;
    for (const Shaft& shaft : mover.shafts) {
        for (int place = shaft.first; place <= shaft.last; ++place) {
            const auto part = static_cast<BlueprintId>(shaft.firstPart + (place - shaft.first));
            gate.parts.push_back(part);
            if (shaft.low >= tileEdge(place + 1) || shaft.high <= tileEdge(place)) continue;
            for (const RunStart& run : shaft.runs) {
                const int tile = static_cast<int>(run.tile);
                CellPlace at = {tile % map.width, tile / map.width, run.level};
                placeAlong(at, axis) = place;
                CellBlueprint block = world.blueprints[part];
                lowEdge(block, axis) = std::max(shaft.low - tileEdge(place), Coordinate{0});
                highEdge(block, axis) = std::min(shaft.high - tileEdge(place), tileEdge(1));
                gate.boxes.push_back(boxOf(at, block));
            }
        }
    }
    gate.bounds = boundsOf(gate.boxes);
    return gate;
}

// Makes textures of a sheet's frames from the second on, and returns the first of these. The sheet
// keeps frame 0, which faces that are not gates show.
TextureId framesOf(World& world, TextureId sheet) {
    const auto later = static_cast<TextureId>(world.textures.size());
    const std::vector<SharedVector<TextureLevel>> frames =
        std::exchange(world.textures[sheet].laterFrames, {});
    for (const SharedVector<TextureLevel>& levels : frames) {
        Texture texture;
        texture.name = world.textures[sheet].name;
        texture.levels = levels;
        texture.seeThrough = world.textures[sheet].seeThrough;
        texture.material = world.textures[sheet].material;
        world.textures.push_back(std::move(texture));
    }
    return later;
}

// Each kind that stands in a map is told to those that it follows.
void listFollowers(World& world) {
    for (GateKind& kind : world.gateKinds) {
        kind.followers.clear();
        kind.openLeaders = 0;
    }
    std::vector<bool> stands(world.gateKinds.size());
    for (const Gate& gate : world.gates) stands[static_cast<std::size_t>(gate.kind)] = true;
    for (std::size_t i = 0; i < stands.size(); ++i) {
        if (!stands[i]) continue;
        const int kind = static_cast<int>(i);
        for (const int leader : world.gateKinds[i].follows)
            world.gateKinds[static_cast<std::size_t>(leader)].followers.push_back(kind);
    }
}

PlacingFault tooManyCells(int map) {
    return {map,
            0,
            0,
            0,
            words("more than ", kMaxGateCells, " cells of gates"),
            "fewer or smaller ones"};
}

}  // namespace

std::vector<PlacingFault> makeGates(World& world) {
    std::vector<BlueprintId> kinds = kindsOf(world, &CellBlueprint::gate);
    if (std::all_of(kinds.begin(), kinds.end(),
                    [](BlueprintId kind) { return kind == kEmptyCell; }))
        return {};
    std::vector<PlacingFault> faults;
    std::size_t cells = kMaxGateCells;
    for (std::size_t id = 0; id < kinds.size(); ++id) {
        if (world.blueprints[id].motion >= 0) kinds[id] = kEmptyCell;
    }
    for (std::size_t i = 0; i < world.movers.size(); ++i) {
        const Mover& mover = world.movers[i];
        if (world.blueprints[mover.shafts[0].firstPart].gate < 0) continue;
        world.gates.push_back(makeMovingGate(world, static_cast<int>(i)));
        const Gate& gate = world.gates.back();
        if (gate.boxes.size() > cells) {
            faults.push_back(tooManyCells(gate.map));
            return faults;
        }
        cells -= gate.boxes.size();
    }
    for (std::size_t map = 0; map < world.maps.size(); ++map) {
        std::vector<std::vector<CellPlace>> groups;
        if (!groupCells(world.maps[map], kinds, cells, groups)) {
            faults.push_back(tooManyCells(static_cast<int>(map)));
            break;
        }
        for (const std::vector<CellPlace>& group : groups) {
            // A gate has at most one part per cell.
            if (world.blueprints.size() + group.size() > static_cast<std::size_t>(kMaxBlueprints)) {
                faults.push_back(
                    {static_cast<int>(map), group[0].x, group[0].y, group[0].level,
                     words("a gate that makes more than ", kMaxBlueprints, " blueprints"),
                     "fewer gates"});
                return faults;
            }
            world.gates.push_back(makeGate(world, static_cast<int>(map), group));
        }
    }
    if (!faults.empty()) return faults;
    listFollowers(world);
    resetGates(world);
    return faults;
}

void makeGateFrames(World& world) {
    std::vector<GateFace> known(world.textures.size());  // by sheet
    for (Gate& gate : world.gates) {
        for (const BlueprintId part : gate.parts) {
            for (int side = 0; side < kFaces; ++side) {
                GateFace face;
                face.part = part;
                face.face = static_cast<Face>(side);
                face.first = world.blueprints[part].face(face.face).texture;
                if (face.first == kNoTexture) continue;
                GateFace& sheet = known[face.first];
                if (sheet.first == kNoTexture && world.textures[face.first].isHeld()) {
                    sheet.first = face.first;
                    sheet.frames = world.textures[face.first].frames();
                    sheet.later = framesOf(world, face.first);
                }
                if (sheet.first == kNoTexture) continue;
                face.later = sheet.later;
                face.frames = sheet.frames;
                gate.faces.push_back(face);
            }
        }
    }
    resetGates(world);
}

}  // namespace slicecast
