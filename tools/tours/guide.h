// Somebody who knows the way: plays a session as a person would, by turning, walking and jumping,
// and records it. Everything goes through the session's input, so a tour can only go where a player
// can.
//
//     Guide guide(world, "castle");
//     guide.walk({{44.5, 20}, {43, 18.9}});
//     guide.mark("in-the-gate");
//     Recording tour = guide.finish();
//
// Lengths are units, angles degrees, looks screen heights, times steps of 1/120 s. Who gets stuck
// says so once, and does nothing any more.
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
    // The same with the head down.
    void creep(const std::vector<Spot>& spots);
    // Ahead to a spot in or behind a portal, until through it; wherever it leads.
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
    // Onto a lift when it is down, and with it until it is up, facing where there is a view.
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
