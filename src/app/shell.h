// Where the program runs: in a window of the desktop or on the canvas of a page. The program gives
// it pictures and reports what happens; the shell calls the program with keys, mouse and time (see
// app.h).
#pragma once

#include "app/frame_meter.h"
#include "base/named.h"

#include <SDL2/SDL_surface.h>

#include <string>

namespace slicecast {

class Session;

// Events of the program, each with a yes or no.
enum class News {
    ready,       // the first picture is on the screen
    pause,       // yes: paused
    pointer,     // yes: the mouse is captured and looks around
    cursor,      // yes: the cursor's place in the picture steers
    recording,   // yes: recording
    replay,      // yes: a recording is being replayed
    fly,         // yes: fly mode; no: walk mode
    overlay,     // yes: some overlay is shown
    help,        // its key was pressed
    rate,        // its key was pressed
    sound,       // its key was pressed
    fullscreen,  // its key was pressed
    record,      // its key was pressed
    quest,       // the session has news of the world's game (Session::takeNews)
};
// As a page hears of them.
inline constexpr Named<News> kNews[] = {
    {News::ready, "ready"},   {News::pause, "pause"},         {News::pointer, "pointer"},
    {News::cursor, "cursor"}, {News::recording, "recording"}, {News::replay, "replay"},
    {News::fly, "fly"},       {News::overlay, "overlay"},     {News::help, "help"},
    {News::rate, "rate"},     {News::sound, "sound"},         {News::fullscreen, "fullscreen"},
    {News::record, "record"}, {News::quest, "quest"}};

class Shell {
public:
    virtual ~Shell() = default;

    // Any steady clock.
    virtual double nowSeconds() const = 0;

    // Puts a picture (RGBA32) on the screen.
    virtual void show(SDL_Surface& picture) = 0;

    // App::wantsFrame() has become true: call App::frame until it is false again.
    virtual void askForFrame() = 0;

    virtual void tell(News news, bool yes) = 0;
    // A picture is on the screen; `moved` if the eye has moved since the picture before.
    virtual void tellShown(bool moved) = 0;
    // The player has gone through a portal between these maps.
    virtual void tellPortal(const std::string& from, const std::string& to) = 0;
    virtual void tellRates(const FrameRates& rates) = 0;
    virtual void tellSize(int width, int height) = 0;

    // The user asks for the hits of a slice in a picture of this size (see answers/hits_json.h).
    virtual void tellHits(Session& game, int width, int height, int column) = 0;

    // Escape: releases the mouse if it is captured, else leaves.
    virtual void leave() = 0;
};

}  // namespace slicecast
