// The place in which the program runs: a window of the desktop or the canvas of a page. The program
// hands it pictures and tells it what happens; it calls the program with keys, the mouse and time
// (see app.h).
#pragma once

#include "app/frame_meter.h"
#include "base/named.h"

#include <SDL2/SDL_surface.h>

#include <string>

namespace slicecast {

class Session;

// What happens in the program, each with a yes or no.
enum class News {
    ready,       // the first picture is on the screen
    pause,       // play stands still, or goes on
    pointer,     // the mouse looks around, or is free
    cursor,      // the cursor's place in the picture steers, or not
    recording,   // what is done is recorded, or no more
    replay,      // a recording is played, or it is over
    fly,         // fly mode, or walk mode
    overlay,     // some overlay is shown, or none
    help,        // its key was pressed
    rate,        // the same
    fullscreen,  // the same
    record,      // the same
};
// As a page hears of them.
inline constexpr Named<News> kNews[] = {
    {News::ready, "ready"},   {News::pause, "pause"},           {News::pointer, "pointer"},
    {News::cursor, "cursor"}, {News::recording, "recording"},   {News::replay, "replay"},
    {News::fly, "fly"},       {News::overlay, "overlay"},       {News::help, "help"},
    {News::rate, "rate"},     {News::fullscreen, "fullscreen"}, {News::record, "record"}};

class Shell {
public:
    virtual ~Shell() = default;

    // Any steady clock.
    virtual double nowSeconds() const = 0;

    // Puts a picture (RGBA32) on the screen.
    virtual void show(SDL_Surface& picture) = 0;

    // App::wantsFrame() has become true, so App::frame is to be called, until it is false again.
    virtual void askForFrame() = 0;

    virtual void tell(News news, bool yes) = 0;
    // A picture is on the screen; `moved` if its eye is not where it was in the picture before.
    virtual void tellShown(bool moved) = 0;
    // The player has gone through a portal. Names of maps.
    virtual void tellPortal(const std::string& from, const std::string& to) = 0;
    virtual void tellRates(const FrameRates& rates) = 0;
    virtual void tellSize(int width, int height) = 0;

    // What that slice of a picture of that size meets is asked for (see session/hits_json.h).
    virtual void tellHits(Session& game, int width, int height, int column) = 0;

    // Escape: frees the mouse, or, where it is free, leaves.
    virtual void leave() = 0;
};

}  // namespace slicecast
