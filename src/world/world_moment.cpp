#include "world/world_moment.h"

#include "world/world.h"

namespace slicecast {
namespace {

template <typename Value>
std::size_t bytesOf(const std::vector<Value>& values) {
    return values.capacity() * sizeof(Value);
}

}  // namespace

std::size_t WorldMoment::bytes() const {
    std::size_t sum = sizeof(WorldMoment) + bytesOf(movers) + bytesOf(gates) +
                      bytesOf(objects.motions) + bytesOf(objects.counts) +
                      bytesOf(objects.changed) + bytesOf(quest.takenOfKind) + bytesOf(quest.finds) +
                      bytesOf(quest.notices);
    for (const Find& find : quest.finds) sum += find.message.capacity();
    for (const Notice& notice : quest.notices) sum += notice.text.capacity();
    return sum;
}

WorldMoment momentOf(const World& world) {
    return {.movers = momentOfMovers(world),
            .gates = momentOfGates(world),
            .nextLookout = world.nextLookout,
            .objects = momentOfObjects(world),
            .quest = momentOfQuest(world),
            .steps = world.steps};
}

void restore(World& world, const WorldMoment& moment) {
    restoreMovers(world, moment.movers);
    restoreGates(world, moment.gates);
    world.nextLookout = moment.nextLookout;
    restoreObjects(world, moment.objects);
    restoreQuest(world, moment.quest);
    world.steps = moment.steps;
}

}  // namespace slicecast
