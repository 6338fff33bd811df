// A sort for lists that are short or sorted once. std::sort is written out anew, some kilobytes each time, for every kind of thing and order; what a page
// loads should be small, and this is a tenth of it.
#pragma once

#include <algorithm>

namespace slicecast {

// Heap sort. The order is total: no two things are equal in it.
template <typename Things, typename Less>
void heapSort(Things& things, Less isBefore) {
    std::partial_sort(things.begin(), things.end(), things.end(), isBefore);
}

}  // namespace slicecast
