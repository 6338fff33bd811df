#include "base/hash_index.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

namespace slicecast {
namespace {

// Few hashes, so that many keys have the same one.
std::uint32_t hashOf(std::uint64_t key) {
    return static_cast<std::uint32_t>(key % 40);
}

TEST(HashIndex, FindsWhatWasAdded) {
    Random random(7);
    std::vector<std::uint64_t> keys;
    std::map<std::uint64_t, std::uint32_t> expected;
    HashIndex index(2);
    const auto find = [&](std::uint64_t key) {
        return index.find(hashOf(key), [&](std::uint32_t i) { return keys[i] == key; });
    };
    for (int i = 0; i < 1000; ++i) {
        const auto key = static_cast<std::uint64_t>(random.below(500));
        const auto known = expected.find(key);
        ASSERT_EQ(find(key), known == expected.end() ? HashIndex::kNone : known->second);
        if (known != expected.end()) continue;
        index.add(hashOf(key));
        expected[key] = static_cast<std::uint32_t>(keys.size());
        keys.push_back(key);
    }
    EXPECT_EQ(index.count(), keys.size());

    const std::size_t bytes = index.bytes();
    EXPECT_GE(bytes, 2 * keys.size() * sizeof(std::uint32_t));
    index.clear();
    EXPECT_EQ(index.count(), 0u);
    EXPECT_EQ(index.bytes(), bytes);
    EXPECT_EQ(find(keys[0]), HashIndex::kNone);
}

}  // namespace
}  // namespace slicecast
