#include "base/nearest_name.h"

#include "base/words.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

// Limits the length and number of names compared, so that a hostile scene cannot make messages
// slow.
constexpr std::size_t kLongestCompared = 32;
constexpr std::size_t kMostCompared = 500;

// The edit distance: bytes to change, add, leave out or swap with their neighbour. Both texts are
// at most kLongestCompared long.
std::size_t editDistance(std::string_view a, std::string_view b) {
    using Row = std::array<std::size_t, kLongestCompared + 1>;
    Row twoBefore{};
    Row before{};
    Row row{};
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        twoBefore = before;
        before = row;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = before[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u);
            row[j] = std::min({before[j] + 1, row[j - 1] + 1, change});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], twoBefore[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

}  // namespace

std::string_view nearestName(std::string_view wanted, const std::vector<std::string_view>& names) {
    if (wanted.size() > kLongestCompared) return {};
    const std::string lowerWanted = lowerCase(wanted);
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(1, wanted.size() / 3) + 1;
    for (std::size_t i = 0; i < std::min(names.size(), kMostCompared); ++i) {
        if (names[i].size() > kLongestCompared) continue;
        const std::size_t distance = editDistance(lowerWanted, lowerCase(names[i]));
        if (distance >= least || distance >= names[i].size()) continue;
        least = distance;
        nearest = names[i];
    }
    return nearest;
}

std::string didYouMean(std::string_view wanted, const std::vector<std::string_view>& names) {
    const std::string_view nearest = nearestName(wanted, names);
    return nearest.empty() ? std::string() : words(" Did you mean '", nearest, "'?");
}

}  // namespace slicecast
