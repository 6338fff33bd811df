#include "render/strips/open_lanes.h"

#include <algorithm>

namespace slicecast {

void OpenLanes::begin(unsigned bits) {
    first_ = last_ = LaneValues(inAllLanes(0));
    listed_ = 0;
    eachLane(bits, [&](int lane) { read(lane); });
    findEnds();
}

std::span<const LaneRows> OpenLanes::take(Lanes mask, Lanes first, Lanes last) {
    const Lanes from = greater(first, first_.lanes());
    const Lanes to = lesser(last, last_.lanes());
    const Lanes open = mask & (from < to);
    const unsigned bits = bitsOf(open);
    if (bits == 0) return {};
    const unsigned listed = bits & listed_;
    const std::size_t before = listed == 0 ? 0 : takeListed(listed, from, to);
    LaneRows* taken = taken_.data() + before;
    if (bits != listed) {
        const LaneValues a(from);
        const LaneValues b(to);
        eachLane(bits & ~listed, [&](int lane) {
            const int upperEnd = std::min(b.at[lane], gapFirst_.at[lane]);
            const int lowerBegin = std::max(a.at[lane], gapLast_.at[lane]);
            if (a.at[lane] < upperEnd) *taken++ = {lane, a.at[lane], upperEnd};
            if (lowerBegin < b.at[lane]) *taken++ = {lane, lowerBegin, b.at[lane]};
        });
        close(listed == 0 ? open : open & ~maskOf(listed), from, to);
    }
    return {taken_.data(), taken};
}

// Takes runs of the lanes with lists. Returns their number; leaves room for those of the other
// lanes.
std::size_t OpenLanes::takeListed(unsigned bits, Lanes from, Lanes to) {
    const LaneValues a(from);
    const LaneValues b(to);
    std::size_t count = 0;
    eachLane(bits, [&](int lane) {
        for (const auto& [first, last] : rows_[indexOf(lane)].take(a.at[lane], b.at[lane])) {
            if (taken_.size() < count + 1 + 2 * kLanes) taken_.resize(2 * taken_.size());
            taken_[count++] = {lane, first, last};
        }
        read(lane);
    });
    return count;
}

// Closes rows within the first and last ones of each lane in `here`.
void OpenLanes::close(Lanes here, Lanes from, Lanes to) {
    const Lanes first = first_.lanes();
    const Lanes last = last_.lanes();
    const Lanes gapFirst = gapFirst_.lanes();
    const Lanes gapLast = gapLast_.lanes();
    const Lanes none = inAllLanes(kNoGap);
    const Lanes atTop = here & (from == first);
    const Lanes atBottom = here & ~atTop & (to == last);
    const Lanes inside = here & ~atTop & ~atBottom;
    const Lanes beforeGap = to < gapFirst;
    const Lanes behindGap = gapLast < from;
    const Lanes hasGap = gapFirst < none;
    const Lanes apart = inside & hasGap & (beforeGap | behindGap);
    if (const unsigned bits = bitsOf(apart); bits != 0) makeLists(bits, from, to);
    const Lanes gone = (atTop & ~beforeGap) | (atBottom & ~behindGap);
    const Lanes grown = inside & ~apart;
    first_ = LaneValues(chosen(atTop, chosen(beforeGap, to, greater(to, gapLast)), first));
    last_ = LaneValues(chosen(atBottom, chosen(behindGap, from, lesser(from, gapFirst)), last));
    gapFirst_ = LaneValues(chosen(gone, none, chosen(grown, lesser(from, gapFirst), gapFirst)));
    gapLast_ = LaneValues(
        chosen(gone, none, chosen(grown, chosen(hasGap, greater(to, gapLast), to), gapLast)));
}

// Makes lists for lanes that get a second gap.
void OpenLanes::makeLists(unsigned bits, Lanes from, Lanes to) {
    const LaneValues a(from);
    const LaneValues b(to);
    eachLane(bits, [&](int lane) {
        write(lane);
        rows_[indexOf(lane)].take(a.at[lane], b.at[lane]);
        listed_ |= 1u << lane;
    });
}

void OpenLanes::close(unsigned bits) {
    eachLane(bits, [&](int lane) { last_.at[lane] = first_.at[lane]; });
    listed_ &= ~bits;
}

void OpenLanes::findEnds() {
    const Lanes first = first_.lanes();
    const Lanes last = last_.lanes();
    const Lanes open = first < last;
    live_ = bitsOf(open);
    leastFirst_ = leastOf(chosen(open, first, inAllLanes(kNoGap)));
    greatestLast_ = greatestOf(chosen(open, last, inAllLanes(-1)));
}

void OpenLanes::write(int lane) {
    if (listed_ >> lane & 1) return;
    OpenRows& rows = rows_[indexOf(lane)];
    if (first_.at[lane] >= last_.at[lane]) {
        rows.closeAll();
    } else if (gapFirst_.at[lane] == kNoGap) {
        rows.open({first_.at[lane], last_.at[lane]});
    } else {
        rows.open({first_.at[lane], gapFirst_.at[lane]}, {gapLast_.at[lane], last_.at[lane]});
    }
}

void OpenLanes::read(int lane) {
    const OpenRows& rows = rows_[indexOf(lane)];
    const std::vector<OpenRows::Run>& runs = rows.runs();
    const bool hasGap = runs.size() == 2;
    first_.at[lane] = inLane(rows.first());
    last_.at[lane] = inLane(rows.last());
    gapFirst_.at[lane] = inLane(hasGap ? runs[0].last : kNoGap);
    gapLast_.at[lane] = inLane(hasGap ? runs[1].first : kNoGap);
    listed_ = (listed_ & ~(1u << lane)) | (runs.size() > 2 ? 1u << lane : 0u);
}

}  // namespace slicecast
