// A sort with little code per element type: each use of std::sort adds some kilobytes, and what a
// page loads should be small.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace slicecast {

// Stable merge sort. `room` is scratch memory; keep it between calls to avoid allocations.
template <typename Thing, typename Less>
void mergeSort(std::vector<Thing>& things, std::vector<Thing>& room, Less isBefore) {
    const std::size_t count = things.size();
    room.resize(count);
    for (std::size_t run = 1; run < count; run *= 2) {
        std::size_t to = 0;
        while (to < count) {  // NOLINT(bugprone-infinite-loop): `to` grows in it
            std::size_t a = to;
            const std::size_t aEnd = std::min(a + run, count);
            std::size_t b = aEnd;
            const std::size_t bEnd = std::min(b + run, count);
            while (to < bEnd)
                room[to++] = std::move(a < aEnd && (b >= bEnd || !isBefore(things[b], things[a]))
                                           ? things[a++]
                                           : things[b++]);
        }
        things.swap(room);
    }
}

template <typename Thing, typename Less>
void mergeSort(std::vector<Thing>& things, Less isBefore) {
    std::vector<Thing> room;
    mergeSort(things, room, isBefore);
}

}  // namespace slicecast
