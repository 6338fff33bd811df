// Finds which bodies may touch which movers and gates, once for each step.
//
//     findEncounters(world, bodies);
//     eachEncounter(world.encounters, gate.firstEncounter, [&](int body) { ... });
//
// Each mover and each gate has a list of the bodies that are near a block of it, in their own map
// or through a portal. So a step takes a time that grows with the number of bodies plus the number
// of movers and gates, not with their product.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace slicecast {

struct Body;
struct World;

// An entry of a list.
struct Encounter {
    int body = 0;   // index into the bodies of the step
    int next = -1;  // index of the list's next entry, -1 at the end
};

// Fills World::encounters, and Mover::firstEncounter and Gate::firstEncounter.
void findEncounters(World& world, std::span<const Body> bodies);

// Calls action(body) for each entry of the list that begins at `first`.
template <typename Action>
void eachEncounter(const std::vector<Encounter>& encounters, int first, Action action) {
    for (int i = first; i >= 0; i = encounters[static_cast<std::size_t>(i)].next)
        action(encounters[static_cast<std::size_t>(i)].body);
}

}  // namespace slicecast
