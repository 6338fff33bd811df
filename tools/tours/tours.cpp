#include "tours/tours.h"

#include <array>

namespace slicecast {
namespace {

void throughTheHarbourTown(Guide& guide) {
    guide.lookAround();
    guide.mark("at-the-start");
    guide.walk({{18.3, 36.2}, {17.5, 34.5}, {12.5, 34}});
    guide.run({{12.5, 24}});
    guide.mark("along-the-canal");
    guide.walk({{14, 21.7}, {16.5, 21.7}, {21.5, 21.7}});
    guide.turnTo(0.0);
    guide.lookTo(-0.25);
    guide.mark("on-the-bridge");
    guide.lookTo(0.0);
    guide.jump();
    guide.walk({{26.5, 21.7}, {25.5, 19}, {25.5, 10}});
    guide.creep({{30, 9}});
    guide.mark("with-the-head-down");
    guide.walk({{34.5, 8}, {39.5, 7}, {39.5, 5.5}, {30.5, 5.5}});
    guide.mark("on-the-town-wall");
    guide.walk({{30.5, 4.5}, {21.5, 4.5}});
    // The steps before one's feet, not the wall.
    guide.lookTo(-0.4);
    guide.run({{21.5, 6.5},
               {22.5, 6.5},
               {22.5, 8.5},
               {20.5, 8.5},
               {20.5, 6.5},
               {22.5, 6.5},
               {22.5, 7.4}});
    guide.lookTo(0.0);
    guide.lookAround();
    guide.mark("on-the-tower");
}

void throughTheCastle(Guide& guide) {
    guide.lookAround();
    guide.turnTo(184.0);
    guide.lookTo(0.06);
    guide.mark("before-the-gate");
    guide.lookTo(0.0);
    guide.walk({{42.5, 19.4}, {30, 19.1}});
    guide.mark("on-the-bridge");
    // The gate opens for who comes, and obeys
    guide.walk({{27.4, 19}});
    guide.wait(90);
    guide.mark("the-gate-is-open");
    guide.use();
    guide.wait(45);
    guide.mark("the-gate-closes");
    guide.use();
    guide.wait(90);
    guide.run({{22, 19.1}});
    guide.jump();
    guide.walk({{22.4, 24.2}});
    guide.rideUp({23.5, 25}, 180.0);
    guide.walk({{24.5, 25}});
    guide.turnTo(205.0);
    guide.lookTo(-0.1);
    guide.mark("on-the-wall-walk");
    guide.lookTo(0.0);
    guide.walk({{24.5, 29.5},
                {22, 29.5},
                {14.5, 29.5},
                {12.5, 29.4},
                {12.5, 22.5},
                {16.5, 22.5},
                {16.5, 17.5},
                {12, 17.5},
                {11.6, 18.4},
                {15, 20}});
    guide.stepAside(0.5, 30);
    guide.mark("in-the-court");
    guide.walk({{18.5, 20}});
    guide.creep({{18.5, 22}});
    guide.walk({{18.5, 27}, {12.5, 27.5}, {10.5, 27.5}});
    // The steps before one's feet, not the wall.
    guide.lookTo(-0.3);
    guide.run({{9.5, 27.5},
               {8.5, 27.5},
               {8.5, 29.5},
               {10.5, 29.5},
               {10.5, 27.5},
               {8.5, 27.5},
               {8.5, 29.5},
               {10.5, 29.5},
               {10.5, 27.5},
               {8.5, 27.5},
               {8.5, 29.5}});
    guide.lookTo(0.0);
    guide.lookAround();
    guide.mark("on-the-great-tower");
    guide.setFlying(true);
    guide.lookTo(-0.3);
    guide.flyTo({40, 30}, 16.5);
    guide.turnTo(205.0);
    guide.mark("above-the-castle");
}

void throughTheLibrary(Guide& guide) {
    guide.walk({{13.9, 27}, {13.7, 19.5}});
    guide.lookTo(0.5);
    guide.mark("below-the-tower-of-books");
    guide.lookTo(0.0);
    guide.walk({{13.5, 18.5}, {11.5, 18.5}, {11.5, 13.5}, {6.5, 13.5}});
    guide.mark("first-gallery");
    guide.jump();
    guide.creep({{6.5, 8}});
    guide.walk({{6.5, 3}, {8.5, 2.5}, {8.4, 1.5}, {16.5, 1.5}, {24.5, 1.5}});
    guide.lookAround();
    guide.mark("second-gallery");
    guide.run({{24.5, 16.5}});
    guide.walk({{16.5, 16.5}});
    guide.mark("over-the-high-bridge");
    guide.walk({{16.5, 18.5}, {14.5, 18.5}, {14.5, 16}});
    guide.turnTo(315.0);
    guide.lookTo(-0.15);
    guide.mark("on-the-tower-of-books");
}

void throughTheGarden(Guide& guide) {
    guide.lookAround();
    guide.walk({{21, 35.5}, {21, 31.4}});
    guide.jump();
    guide.mark("at-the-hedge");
    guide.run({{17, 31}, {16.6, 25.5}, {21.5, 25.5}, {20.5, 25.5}, {20.5, 23.5}, {13.5, 23.5}});
    guide.mark("in-the-maze");
    guide.walk({{13.5, 21.5}, {11.5, 21.5}, {11.5, 23.5}, {5.5, 23.5}});
    guide.creep({{5.5, 20}});
    guide.walk({{5.5, 15.5}, {8.5, 15.5}, {8.5, 17.5}, {9.5, 17.5}, {9.5, 19.5}, {12.5, 19.5}});
    guide.lookTo(0.4);
    guide.mark("below-the-tree");
    guide.lookTo(0.0);
    guide.walk({{11.5, 18.4},
                {11.5, 17.5},
                {10.5, 17.5},
                {10.5, 13.5},
                {14.5, 13.5},
                {14.5, 17.5},
                {12.5, 17.5}});
    guide.mark("in-the-tree-house");
    guide.walk({{11.3, 17.4}, {10.4, 17.4}, {10.4, 14}, {10.5, 13.5}, {18, 13.5}});
    guide.lookTo(-0.3);
    guide.mark("on-the-high-bridge");
    guide.lookTo(0.0);
    guide.walk({{21, 15}});
    guide.lookAround();
    guide.turnTo(180.0);
    guide.mark("on-the-pavilion");
}

void throughTheTemple(Guide& guide) {
    guide.lookAround();
    guide.walk({{20, 30}, {20, 22}});
    guide.jumpAhead();
    guide.mark("at-the-great-stairs");
    guide.walk({{20, 10.5}, {20, 8.2}});
    guide.mark("in-the-shrine");
    guide.creep({{20, 10.5}});
    guide.run({{20, 20.5}, {28, 22.5}});
    guide.walk({{30.5, 23}, {30.5, 24.4}, {15.5, 24.5}});
    guide.lookTo(0.4);
    guide.mark("in-the-gorge");
    guide.lookTo(0.0);
    guide.walk({{15.5, 16.5}, {17.5, 9}, {19.5, 5.5}});
    guide.mark("in-the-crypt");
    guide.walk({{12.5, 5.5}, {12, 14}});
    guide.setFlying(true);
    guide.flyTo({14, 18}, 10.0);
    guide.turnTo(330.0);
    guide.lookTo(-0.3);
    guide.mark("above-the-canyon");
}

void throughTheGlassworks(Guide& guide) {
    guide.wait(40);
    guide.mark("before-the-works");
    guide.walk({{15, 29.5}, {15, 25}, {15, 21.5}, {15, 17}});
    guide.lookTo(-0.25);
    guide.mark("in-the-glasshouse");
    guide.lookTo(0.0);
    guide.walk({{15, 8}, {13.5, 7.6}});
    guide.turnTo(190.0);
    guide.lookTo(0.15);
    guide.mark("stained-glass");
    guide.lookTo(0.0);
    guide.walk({{10.5, 6.5}, {10.5, 2.5}, {7.5, 2.5}, {4.4, 3.2}});
    guide.turnTo(75.0);
    guide.wait(40);
    guide.mark("behind-the-waterfall");
    guide.walk({{5, 5.5}, {6.5, 5.5}, {6.5, 8.5}, {6.5, 12}});
    guide.turnTo(250.0);
    guide.mark("at-the-stream");
    guide.walk({{6.5, 20},
                {4.5, 22},
                {6.5, 23},
                {8.5, 23.5},
                {15, 23.5},
                {15, 21.5},
                {15, 15},
                {22.5, 15},
                {27.5, 15},
                {28.6, 13}});
    guide.turnTo(0.0);
    guide.lookTo(-0.1);
    guide.mark("over-the-lava");
    guide.lookTo(0.0);
    guide.walk({{32.5, 13},
                {29, 13},
                {27.5, 15},
                {24.5, 15.2},
                {24.5, 11},
                {24, 9.5},
                {24, 3.5},
                {7, 3.5},
                {4.5, 3.5},
                {2.5, 3.5},
                {2.5, 14},
                {8, 14}});
    guide.turnTo(35.0);
    guide.lookTo(-0.35);
    guide.mark("on-the-rope-bridge");
    guide.lookTo(0.0);
    guide.walk({{12, 14}, {27, 14}});
    guide.setFlying(true);
    guide.flyTo({30, 26}, 9.0);
    guide.turnTo(235.0);
    guide.lookTo(-0.35);
    guide.mark("above-the-glassworks");
}

void throughTheWaterPalace(Guide& guide) {
    guide.wait(60);
    guide.mark("the-palace-in-the-lake");
    guide.walk({{20.5, 41.5}, {29.5, 41.5}, {30.5, 41.2}});
    guide.run({{30.5, 27}});
    guide.turnTo(230.0);
    guide.mark("from-the-bridge");
    guide.walk({{30.5, 22.5}, {24.5, 22.5}, {24.6, 20}});
    guide.turnTo(20.0);
    guide.lookTo(-0.2);
    guide.wait(60);
    guide.mark("the-pool-breathes");
    guide.lookTo(0.0);
    guide.walk({{20.5, 19.2}, {20.5, 16.2}});
    guide.lookTo(-0.12);
    guide.mark("in-the-hall");
    guide.walk({{17, 15.4}, {17.5, 10.4}});
    guide.turnTo(270.0);
    guide.mark("a-painted-window-and-a-real-one");
    guide.lookTo(0.0);
    guide.walk({{17, 15.4},
                {20.5, 16.2},
                {20.5, 19.4},
                {28.6, 19.4},
                {29.5, 18.4},
                {29.5, 9.4},
                {27, 9.5},
                {23.7, 9.4}});
    guide.turnTo(200.0);
    guide.lookTo(-0.15);
    guide.mark("on-the-wet-roof");
    guide.lookTo(0.0);
    guide.walk({{18.5, 9.4}, {18.4, 12.5}});
    guide.turnTo(5.0);
    guide.lookTo(-0.45);
    guide.mark("above-the-pool");
    guide.lookTo(0.0);
    guide.walk({{20.5, 12.5}});
    guide.lookAround();
    guide.mark("in-the-pool");
    guide.walk({{20.5, 15.5}, {20.5, 19.5}, {20, 23.5}, {20, 33}});
    guide.turnTo(270.0);
    guide.mark("swimming-in-the-lake");
    guide.creep({{20, 29.5}});
    guide.mark("below-the-surface");
    guide.walk({{18, 28}});
    guide.setFlying(true);
    guide.flyTo({16, 31}, 7.0);
    guide.turnTo(285.0);
    guide.lookTo(-0.2);
    guide.mark("above-the-lake");
}

void throughTheWayhouse(Guide& guide) {
    guide.wait(60);
    guide.mark("four-gates");
    guide.walk({{6.5, 8}, {3.5, 4}});
    guide.goThrough({3.5, 0.5});
    guide.mark("on-the-shore");
    guide.walk({{15.5, 17}, {13.5, 14.5}, {13.5, 6}});
    guide.lookAround();
    guide.walk({{13.5, 14.5}, {15.5, 17}});
    guide.mark("before-the-gate-to-the-inn");
    guide.goThrough({15.5, 20.5});
    guide.walk({{3.5, 3.5}});
    guide.goThrough({0.5, 3.5});
    guide.mark("on-the-moor");
    guide.walk({{15.5, 20}, {12.5, 20}, {10.5, 19.6}});
    guide.mark("before-the-pale-stones");
    guide.goThrough({10.5, 17.5});
    guide.mark("in-the-garden-at-night");
    guide.walk({{12, 17}, {12, 7}, {13.5, 5}});
    guide.goThrough({13.5, 2.5});
    guide.walk({{9.5, 3.5}});
    guide.goThrough({12.5, 3.5});
    guide.walk({{12.5, 16}});
    guide.mark("in-the-deep");
    guide.walk({{12.5, 18.5}});
    guide.goThrough({12.5, 21.5});
    guide.walk({{9.5, 5}, {6.5, 8}, {6.5, 14}});
    guide.goThrough({6.5, 17.5});
    guide.mark("in-the-court");
    guide.walk({{13, 7}, {3, 8.5}});
    guide.goThrough({0.5, 8.5});
    guide.walk({{5.5, 1.9}});
    guide.goThrough({9.5, 1.9});
    guide.mark("once-around-the-corridor");
    guide.goThrough({9.5, 1.9});
    guide.walk({{4.5, 1.9}});
    guide.goThrough({4.5, 0.5});
    guide.walk({{3, 12}, {3, 15.5}});
    guide.goThrough({0.5, 15.5});
    guide.walk({{6.5, 1.9}});
    guide.goThrough({10.5, 1.9});
    guide.mark("up-the-stairs");
    guide.goThrough({10.5, 1.9});
    guide.goThrough({0.5, 1.9});
    guide.walk({{5.5, 1.9}});
    guide.goThrough({5.5, 0.5});
    guide.walk({{5, 16.5}, {18, 17}, {21.5, 17}});
    guide.goThrough({21.5, 14.5});
    guide.walk({{8.5, 11}});
    guide.mark("in-the-hut");
    guide.walk({{8.5, 14.5}});
    guide.goThrough({8.5, 16.5});
    guide.walk({{25.5, 17}, {27, 9}});
    guide.goThrough({30.5, 8.5});
    guide.walk({{6.5, 5.5}});
    guide.goThrough({12.5, 5.5});
    guide.mark("in-the-lane");
    guide.walk({{6.5, 5.5}});
    guide.goThrough({6.5, 3.5});
    guide.walk({{24, 9.5}, {10.5, 9.5}});
    guide.walk({{8.5, 11.3}});
    guide.lookTo(-0.6);
    guide.mark("at-the-well");
    guide.goThrough({8.5, 12.5});
    guide.lookTo(0.0);
    guide.wait(60);
    guide.mark("fallen-out-of-the-roof");
}

void throughTheHillAbbey(Guide& guide) {
    guide.lookAround();
    guide.mark("by-the-pool");
    guide.walk({{24, 43.5}, {14, 43.5}});
    guide.turnTo(270.0);
    guide.walk({{14, 36.5}});
    guide.mark("on-the-bridge");
    guide.walk({{14, 29.7}});
    guide.wait(120);
    guide.mark("the-gate-is-open");
    guide.walk({{14, 24.4}, {14, 23.3}, {9.7, 22.5}, {9.5, 17.4}, {8.5, 17.2}});
    guide.turnTo(270.0);
    guide.mark("before-the-crypt");
    guide.goThrough({8.5, 15.5});
    guide.walk({{6.5, 9}});
    guide.lookTo(0.2);
    guide.mark("in-the-crypt");
    guide.lookTo(0.0);
    guide.goThrough({6.5, 12.5});
    guide.walk({{9.5, 17.4}, {9.7, 22.5}, {16.2, 24.4}, {20, 24.5}});
    guide.run({{20, 15.4}});
    guide.mark("up-the-ramp");
    guide.walk({{20, 12.5}, {19.5, 8.5}, {22.5, 8.5}});
    guide.turnTo(180.0);
    guide.lookTo(0.15);
    guide.mark("in-the-abbey");
    guide.lookTo(0.0);
    guide.walk({{20, 8.5}, {20, 13}, {29.5, 13}, {29.5, 11.3}});
    guide.rideUp({29.5, 8.5}, 180.0);
    guide.lookTo(-0.05);
    guide.mark("on-the-tower");
}

// A keepsake in each land, then the last gate.
void throughTheHunt(Guide& guide) {
    guide.wait(60);
    guide.mark("in-the-hall");
    guide.walk({{8.5, 8}, {8.5, 3}});
    guide.use();
    guide.wait(60);
    guide.mark("the-last-gate-is-shut");
    guide.walk({{3.5, 5.5}});
    guide.goThrough({0.5, 5.5});
    guide.walk({{8.5, 9.5}, {9.4, 5.5}, {12.5, 5.4}});
    guide.lookTo(-0.15);
    guide.walk({{12.5, 3.7}});
    guide.mark("the-shell");
    guide.lookTo(0.0);
    guide.walk({{12.5, 5.4}, {9.4, 6}, {8.5, 9.5}, {8.5, 12}});
    guide.goThrough({8.5, 14.5});
    guide.walk({{2.8, 8}, {3, 11.5}});
    guide.goThrough({0.5, 11.5});
    guide.walk({{8.5, 11}, {8.5, 5.5}});
    guide.mark("the-lantern");
    guide.turnTo(120.0);
    guide.wait(120);
    guide.mark("the-lamb");
    guide.walk({{8.5, 11}, {8.5, 12}});
    guide.goThrough({8.5, 14.5});
    guide.walk({{2.6, 13}, {13.6, 13}, {14, 11.5}});
    guide.goThrough({16.5, 11.5});
    guide.walk({{8.5, 9}, {8.5, 6.4}});
    guide.mark("the-moonflower");
    guide.walk({{8.5, 9}, {8.5, 12}});
    guide.goThrough({8.5, 14.5});
    guide.walk({{14, 8}, {14, 5.5}});
    guide.goThrough({16.5, 5.5});
    guide.walk({{6, 11.5}, {6, 8.5}, {8.5, 7.6}, {8.5, 4.9}});
    guide.mark("the-crystal");
    guide.walk({{8.5, 7.6}, {6, 8.5}, {6, 11.5}, {8.5, 12}});
    guide.goThrough({8.5, 14.5});
    guide.walk({{13.6, 3.6}, {8.5, 3.2}});
    guide.use();
    guide.wait(170);
    guide.mark("the-last-gate-opens");
    guide.goThrough({8.5, 0.5});
    guide.walk({{8.5, 10}});
    guide.lookAround();
    guide.mark("on-the-terrace");
}

constexpr std::array kTours = {
    Tour{"castle", throughTheCastle},         Tour{"garden", throughTheGarden},
    Tour{"glassworks", throughTheGlassworks}, Tour{"harbour-town", throughTheHarbourTown},
    Tour{"hill-abbey", throughTheHillAbbey},  Tour{"library", throughTheLibrary},
    Tour{"temple", throughTheTemple},         Tour{"water-palace", throughTheWaterPalace},
    Tour{"wayhouse", throughTheWayhouse},     Tour{"wayhouse-hunt", throughTheHunt},
};

}  // namespace

std::span<const Tour> allTours() {
    return kTours;
}

}  // namespace slicecast
