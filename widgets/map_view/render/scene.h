#pragma once

#include <functional>
#include <memory>

#include <QImage>

#include "core/base/result.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

class EglDisplay;

/// What a picture shall look like.
struct DrawOrder {
    MapCamera camera;
    QSize size;               ///< logical pixels
    double pixelRatio = 1.0;  ///< device pixels in a logical one
    bool full = true;         ///< all points; else as many as can be drawn quickly

    bool operator==(const DrawOrder&) const = default;
};

/// A picture and what it shows.
struct MapPicture {
    QImage image;
    DrawOrder order;
    SceneContentPtr content;
    bool complete = false;  ///< every point of the content was drawn
};

/// What one view draws with VTK, in an OpenGL context of its own. Render thread only.
class Scene {
public:
    [[nodiscard]] static Result<std::unique_ptr<Scene>> create(const EglDisplay& display);
    ~Scene();

    void setContent(SceneContentPtr content);
    /// Draws; a full picture is refined in steps and ends early, incomplete, when @p interrupted says so.
    [[nodiscard]] MapPicture draw(const DrawOrder& order, const std::function<bool()>& interrupted);

private:
    struct State;
    explicit Scene(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
