#include "app/window/panes/view_context.h"

#include <QString>

#include "app/window/source/moment_source.h"

namespace leitstand {

void ViewContext::notify(const QString& text) const {
    source.notify(text);
}

}  // namespace leitstand
