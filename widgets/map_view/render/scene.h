#pragma once

#include <functional>
#include <memory>

#include <QImage>

#include "core/base/result.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

class EglDisplay;

/// A request for a picture.
struct DrawOrder {
    MapCamera camera;
    QSize size;               ///< logical pixels
    double pixelRatio = 1.0;  ///< device pixels per logical pixel
    bool full = true;         ///< draw all points; otherwise as many as the budget allows

    bool operator==(const DrawOrder&) const = default;
};

/// A picture, and what it shows.
struct MapPicture {
    QImage image;
    DrawOrder order;
    SceneContentPtr content;
    bool complete = false;  ///< whether every point of the content was drawn
};

/// Draws one view with VTK, in its own OpenGL context. Render thread only.
class Scene {
public:
    [[nodiscard]] static Result<std::unique_ptr<Scene>> create(const EglDisplay& display);
    ~Scene();

    void setContent(SceneContentPtr content);
    /// Draws a picture. A full picture is refined in steps. It ends early and incomplete when @p interrupted
    /// returns true.
    [[nodiscard]] MapPicture draw(const DrawOrder& order, const std::function<bool()>& interrupted);

private:
    struct State;
    explicit Scene(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
