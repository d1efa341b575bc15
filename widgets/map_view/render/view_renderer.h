#pragma once

#include <functional>
#include <memory>
#include <string>

#include "widgets/map_view/render/scene.h"

namespace leitstand {

class RenderThread;

/// One view's side of the render thread. GUI thread; never waits for the render thread except in drawNow().
class ViewRenderer {
public:
    /// Called on the render thread, never after the destructor has returned.
    struct Callbacks {
        std::function<void(MapPicture)> onPicture;
        std::function<void(std::string)> onFailure;  ///< nothing will ever be drawn, once
    };

    explicit ViewRenderer(Callbacks callbacks);
    ~ViewRenderer();
    ViewRenderer(const ViewRenderer&) = delete;
    ViewRenderer& operator=(const ViewRenderer&) = delete;

    /// What is drawn from now on; the newest wins.
    void setContent(SceneContentPtr content);
    /// Asks for a picture; the newest order wins, a picture under way is cut short.
    void draw(const DrawOrder& order);
    /// A complete picture of the newest content, without calling back; empty when drawing is impossible.
    [[nodiscard]] MapPicture drawNow(DrawOrder order);

private:
    struct Shared;
    std::shared_ptr<RenderThread> m_thread;
    std::shared_ptr<Shared> m_shared;
};

}  // namespace leitstand
