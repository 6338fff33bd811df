// Worlds whose blocks move and open while keys are pressed and bodies stand in their way; and what
// the definition says of such a world's state, by a model of its own.
//
//     Works works(seed);
//     works.step();
//     World defined = works.world.copy();
//     works.model.show(defined, 1.0);       works.world should be the same
#pragma once

#include "random_scene.h"

#include "base/random.h"
#include "world/body.h"
#include "world/gate.h"
#include "world/world.h"

#include <cstdint>
#include <string>
#include <vector>

namespace slicecast::judge {

// It reads of a world how it was made, and nothing that a step changes. For worlds without slopes,
// plans, portals and needs.
class WorksModel {
public:
    // Of a world before its first step.
    explicit WorksModel(const World& world);

    // A step of the movers, then of the gates. Moves the bodies along.
    void step(const GateAsk& ask, std::vector<Body>& bodies);

    // Puts all that moves and opens where it is at a part of the way of the last step. The world is
    // one that was made like the first.
    void show(World& world, double part) const;

    int progressOf(std::size_t gate) const { return gates_[gate].progress; }
    Coordinate offsetOf(std::size_t mover) const { return movers_[mover].offset; }
    // One of the blocks of a mover, whole, and of a gate as the rows have it.
    Box blockOf(std::size_t mover) const;
    const Box& doorwayOf(std::size_t gate) const { return gates_[gate].boxes.front(); }

    // What has happened so far, in steps.
    struct Seen {
        int moving = 0;     // movers with a clock that moved
        int opening = 0;    // gates that moved a block
        int heard = 0;      // gates that a key has turned
        int led = 0;        // gates that another has turned
        int waiting = 0;    // movers with a clock that waited
        int gatesHeld = 0;  // gates with a motion that waited
        int doorsHeld = 0;  // gates without one that waited
        int ended = 0;      // motions that go once and have come to their end
    };
    const Seen& seen() const { return seen_; }

private:
    // The cells of a mover in one line along its motion.
    struct Line {
        Box cells;  // of all that it can reach
        Coordinate low;
        Coordinate high;
    };
    struct Slider {
        int motion = 0;
        int gate = -1;
        std::vector<Line> lines;
        int steps = 0;  // in which it has not waited
        Coordinate offset;
        Coordinate before;  // the last step
    };
    struct Door {
        int kind = 0;
        int slider = -1;
        std::vector<Box> boxes;
        int progress = 0;
        bool wantsOpen = false;
        bool isNear = false;
        bool isLed = false;
        int unwanted = 0;  // steps for which it has had no reason to be open
        int sinceTimer = 0;
    };

    const Motion& motionOf(const Slider& slider) const;
    Coordinate offsetAfter(const Slider& slider, int steps) const;
    Coordinate offsetWhenOpen(const Slider& slider, int progress) const;
    static Box partOf(const Line& line, const Motion& motion, Coordinate offset);
    // The boxes of all that is solid, one slider left out.
    std::vector<Box> solids(const Slider* without = nullptr) const;
    bool move(Slider& slider, Coordinate offset, std::vector<Body>& bodies);
    Offset wayOf(const Slider& slider, Coordinate offset, const Body& body,
                 const std::vector<Box>& others) const;
    void decide(Door& door, const GateAsk& ask, const std::vector<Body>& bodies);
    void stepDoor(Door& door, const GateAsk& ask, std::vector<Body>& bodies);
    void showDoor(World& world, std::size_t gate) const;
    void showSlider(World& world, std::size_t mover, Coordinate offset) const;

    std::vector<Motion> motions_;
    std::vector<GateKind> kinds_;
    Box grid_;
    std::vector<Box> still_;
    std::vector<Slider> movers_;
    std::vector<Door> gates_;
    Seen seen_;
};

class Works {
public:
    explicit Works(std::uint64_t seed);

    // A step of the world and of the model: keys, bodies that come and go and stay where they are
    // pushed, movers, gates, objects.
    void step();

    // An eye among it all.
    View anyView(int width, int height);

    Random random;
    const bool hasBodies;
    World world;
    WorksModel model;
    std::vector<Body> bodies;   // after the last step
    std::vector<Body> defined;  // the same, by the model

private:
    Body anyBody();
};

// A picture of works after some hundred steps, for a judge that sees them by the model.
Scene worksScene(std::uint64_t seed, int width, int height);

}  // namespace slicecast::judge
