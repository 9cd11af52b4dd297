#include "report/picture/drawing.hpp"

namespace manifuzz {

const std::string_view kPictureStyle = R"(
.paper{fill:#ffffff;stroke:#c9ced6}
.frame{fill:#fafbfc;stroke:#c9ced6}
.title{fill:#14181f}
.subtitle,.quiet{fill:#5a6472}
.legend{fill:#14181f}
.fill.a{fill:#0072b2;fill-opacity:.16}
.fill.b{fill:#e69f00;fill-opacity:.2}
.overlap{fill:#cc3366;fill-opacity:.38}
.edge{stroke-width:1.5;stroke-linecap:round}
.edge.a,.skin.a{stroke:#0072b2}
.edge.b,.skin.b{stroke:#b87900}
.outline{fill:none;stroke-width:1}
.outline.a{stroke:#0072b2}
.outline.b{stroke:#b87900}
.skin{fill:none;stroke-width:1.2;stroke-dasharray:4 3}
.plane{stroke:#6b7280;stroke-width:1;stroke-dasharray:7 4}
.reference{stroke:#14181f;stroke-width:4;stroke-linecap:round}
.incident{stroke:#9b30a8;stroke-width:4;stroke-linecap:round}
.normal{stroke:#14181f;stroke-width:1.8}
.arrow{fill:#14181f}
.normal.subject{stroke:#c0143c}
.normal.oracle{stroke:#00795c}
.arrow.subject{fill:#c0143c}
.arrow.oracle{fill:#00795c}
.leader{stroke:#5a6472;stroke-width:1}
.bar{stroke-width:2}
.bar.subject,.bar.truth{stroke:#c0143c}
.bar.oracle{stroke:#00795c}
.mark-subject{fill:#c0143c;stroke:#ffffff;stroke-width:1.2}
.mark-oracle{fill:none;stroke:#00795c;stroke-width:2.2}
.label{fill:#fafbfc;fill-opacity:.85}
.zoomed{fill:none;stroke:#5a6472;stroke-width:1.1}
.zoom-line{stroke:#5a6472;stroke-width:.8;stroke-dasharray:2 3}
.scale{stroke:#14181f;stroke-width:1.4}
.depth-word{font-weight:bold;fill:#14181f}
.depth-word.subject{fill:#a01030}
.depth-word.oracle{fill:#006048}
.curve{fill:none;stroke:#14181f;stroke-width:1.8;stroke-linejoin:round}
.level{fill:none;stroke:#6b7280;stroke-width:1;stroke-dasharray:4 4}
.ring{fill:none;stroke:#14181f;stroke-width:2.4}
.ray.subject{stroke:#c0143c;stroke-width:1}
.ray.oracle{stroke:#00795c;stroke-width:1}
.letter.a,.vertex.a{fill:#005a8e}
.letter.b,.vertex.b{fill:#8a5a00}
)";

double write_down(Svg& svg, std::string_view text, const Point& at, double right, const Font& font,
                  std::string_view css) {
  double y = at.y();
  for (const std::string& line : wrapped(text, font, right - at.x())) {
    svg.text({at.x(), y}, line, font, css);
    y += font.size * 1.68;
  }
  return y;
}

}  // namespace manifuzz
