// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "html.h"
#include "page_parts.h"

namespace penumbra::reproduce {
namespace {

std::string caption_html(const std::string& title, const std::string& text) {
  std::string html = fmt::format("<figcaption><strong>{}</strong>", escape(title));
  if (!text.empty()) html += fmt::format(" <span>{}</span>", escape(text));
  return html + "</figcaption>\n";
}

std::string radio_html(const Gallery& gallery, std::size_t i) {
  return fmt::format(
      "<input type=\"radio\" name=\"{0}-view\" id=\"{0}-{1}\"{2}><label for=\"{0}-{1}\">{3}</label>"
      "\n",
      escape(gallery.id), i, i == 0 ? " checked" : "", escape(gallery.views[i].name));
}

std::string view_html(const Gallery& gallery, const View& view) {
  const PictureSize size = picture_size(view.bytes);
  std::string html = "<div class=\"view\">";
  html += fmt::format("<img src=\"{}\" alt=\"{}: {}\"", data_uri(escape(view.media), view.bytes),
                      escape(gallery.title), escape(view.name));
  if (size.width > 0) html += fmt::format(" width=\"{}\" height=\"{}\"", size.width, size.height);
  html += fmt::format(
      "><p class=\"files\"><span class=\"name\">{}: </span>"
      "<a href=\"{}\">{}</a>, full size</p></div>\n",
      escape(view.name), escape(file_link(view.file)), escape(view.file));
  return html;
}

}  // namespace

std::string gallery_html(const Gallery& gallery) {
  std::string html = fmt::format("<figure class=\"gallery\" id=\"{}\">\n", escape(gallery.id));
  html += fmt::format("<fieldset><legend>Views of {}</legend>\n", escape(gallery.title));
  if (gallery.views.size() > 1)
    for (std::size_t i = 0; i < gallery.views.size(); ++i) html += radio_html(gallery, i);
  html += "<div class=\"frame\">\n";
  for (const View& view : gallery.views) html += view_html(gallery, view);
  return html + "</div></fieldset>\n" + caption_html(gallery.title, gallery.text) + "</figure>\n";
}

std::string plot_html(const Plot& plot, const std::string& svg) {
  std::string html = fmt::format("<figure class=\"plot\" id=\"{}\">\n", escape(plot.id));
  if (!svg.empty()) {
    const PictureSize size = picture_size(svg);
    html += fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}: {} against {}\">\n",
                        data_uri("image/svg+xml", svg), size.width, size.height, escape(plot.title),
                        escape(plot.y_label), escape(plot.x_label));
  }
  html += caption_html(plot.title, plot.text);
  return html + fmt::format(
                    "<p class=\"files\"><a href=\"{0}.csv\">{0}.csv</a> · "
                    "<a href=\"{0}.svg\">.svg</a> · <a href=\"{0}.png\">.png</a></p>\n"
                    "</figure>\n",
                    escape(file_link(plot.id)));
}

}  // namespace penumbra::reproduce
