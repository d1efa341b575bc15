#pragma once

#include <functional>
#include <memory>
#include <string>

#include "widgets/map_view/render/scene.h"

namespace leitstand {

class RenderThread;

/// What one view can request from the render thread. GUI thread; only drawNow() waits for the render thread.
class ViewRenderer {
public:
    /// Called on the render thread, never after the destructor has returned.
    struct Callbacks {
        std::function<void(MapPicture)> onPicture;
        std::function<void(std::string)> onFailure;  ///< called once: nothing will ever be drawn
    };

    explicit ViewRenderer(Callbacks callbacks);
    ~ViewRenderer();
    ViewRenderer(const ViewRenderer&) = delete;
    ViewRenderer& operator=(const ViewRenderer&) = delete;

    /// Sets the content to draw. Only the newest content is drawn.
    void setContent(SceneContentPtr content);
    /// Requests a picture. Only the newest request is carried out; a picture in progress is interrupted.
    void draw(const DrawOrder& order);
    /// Returns a complete picture of the newest content, without a callback. Empty when drawing is
    /// impossible.
    [[nodiscard]] MapPicture drawNow(DrawOrder order);

private:
    struct Shared;
    std::shared_ptr<RenderThread> m_thread;
    std::shared_ptr<Shared> m_shared;
};

}  // namespace leitstand
