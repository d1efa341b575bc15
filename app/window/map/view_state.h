#pragma once

#include <QObject>

#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// Holds how the map is viewed. Commands change it, views follow it.
class ViewState final : public QObject {
    Q_OBJECT
public:
    explicit ViewState(const MapViewSettings& settings, QObject* parent = nullptr)
        : QObject(parent), m_settings(settings) {}

    [[nodiscard]] const MapViewSettings& settings() const { return m_settings; }
    /// Sets all @p settings. Emits changed() if they differ from the present ones.
    void set(const MapViewSettings& settings) {
        if (settings == m_settings) return;
        m_settings = settings;
        emit changed(m_settings);
    }
    /// Changes some settings: @p change is called with the settings and alters them.
    template <class Change>
    void alter(Change change) {
        MapViewSettings settings = m_settings;
        change(settings);
        set(settings);
    }

signals:
    void changed(const leitstand::MapViewSettings& settings);

private:
    MapViewSettings m_settings;
};

}  // namespace leitstand
