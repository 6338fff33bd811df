// What moves and changes in a world by its steps, at one moment between two of them. A world that
// is restored goes on exactly as it did from there.
//
//     const WorldMoment moment = momentOf(world);
//     ...                                            steps of the world and the quest
//     restore(world, moment);                        the same world, or a copy of it
//
// Cells that somebody has edited are not part of it: see CellEdits.
#pragma once

#include "world/gate.h"
#include "world/mover.h"
#include "world/object_motion.h"
#include "world/quest.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

struct World;

struct WorldMoment {
    std::vector<MoverMoment> movers;
    std::vector<GateMoment> gates;
    std::size_t nextLookout = 0;
    ObjectsMoment objects;
    QuestMoment quest;
    std::int64_t steps = 0;

    std::size_t bytes() const;  // of memory, about
};

WorldMoment momentOf(const World& world);
void restore(World& world, const WorldMoment& moment);

}  // namespace slicecast
