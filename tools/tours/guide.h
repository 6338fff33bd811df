// A scripted player: turns, walks and jumps like a person, and records the session. Everything goes
// through the session's input, so a tour can only go where a player can.
//
//     Guide guide(world, "castle");
//     guide.walk({{44.5, 20}, {43, 18.9}});
//     guide.mark("in-the-gate");
//     Recording tour = guide.finish();
//
// Lengths are in units, angles in degrees, looks in screen heights, times in steps of 1/120 s. A
// guide that gets stuck reports that once in trouble(), and ignores all further calls.
#pragma once

#include "session/recording.h"
#include "session/session.h"

#include <string>
#include <vector>

namespace slicecast {

struct Spot {
    double x = 0.0;
    double y = 0.0;
};

class Guide {
public:
    Guide(World world, const std::string& scene);

    // In straight lines from one spot to the next.
    void walk(const std::vector<Spot>& spots);
    void run(const std::vector<Spot>& spots);
    // The same, crouching.
    void creep(const std::vector<Spot>& spots);
    // Walks towards a spot in or behind a portal until it has passed the portal.
    void goThrough(Spot spot);
    void stepAside(double axis, int steps);
    void jump();
    void jumpAhead();
    void turnTo(double headingDegrees);
    void lookTo(double look);
    // Left, right, up and down.
    void lookAround();
    void wait(int steps);
    // Opens or closes the gates nearby.
    void use();
    // Waits for the lift, steps onto it, and rides up, facing that way.
    void rideUp(Spot spot, double headingDegrees);
    void setFlying(bool flying) { session_.setFlying(flying); }
    void flyTo(Spot spot, double eyeHeight);
    void mark(const std::string& name) { recorder_.mark(name, session_); }

    const std::string& trouble() const { return trouble_; }
    Recording finish() const { return recorder_.finish(session_); }
    const Session& session() const { return session_; }

private:
    void step(const Input& input, int count = 1);
    void goTo(Spot spot, Input pace);
    Input towards(Spot spot, Input pace) const;
    double distanceTo(Spot spot) const;
    double turnTowards(Spot spot) const;
    void waitForLift(Spot spot, bool isUp);

    Session session_;
    Recorder recorder_;
    std::string trouble_;
};

}  // namespace slicecast
