#include "benchmark/experiments/kit/page.hpp"

#include "benchmark/experiments/kit/table.hpp"
#include "report/html_text.hpp"

namespace opal::experiments {

std::string page_of(const std::string& title, const std::string& body) {
  return "<!doctype html>\n<html lang=en><meta charset=utf-8><meta name=viewport "
         "content='width=device-width'><title>" +
         html_text(title) +
         "</title>\n<style>\n"
         "body{font:15px/1.5 sans-serif;margin:2rem;color:#1b1b1b;max-width:100rem}\n"
         ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-"
         "nums}\n"
         "th,td{padding:.12rem "
         ".6rem;text-align:right;white-space:nowrap}th[scope=row]{text-align:left;font-weight:400}\n"
         "tbody tr:first-child th{font-weight:700;border-top:2px solid #444;padding-top:.5rem}\n"
         "td.all{text-align:left;white-space:normal;color:#333;padding-bottom:1rem}\n"
         "figure{margin:.5rem;display:inline-block;vertical-align:top;width:32rem;max-width:100%}figure."
         "whole{width:100%;display:block}\n"
         "figure svg{width:100%;height:auto;max-height:24rem;border:1px solid #ddd}figure.whole "
         "svg{max-height:56rem}figcaption{font-size:13px;color:#333}\n"
         "i.box{display:inline-block;width:1em;height:.7em;margin:0 .3em 0 1em}\n"
         "</style>\n<h1>" +
         html_text(title) + "</h1>\n" + body + "</html>\n";
}

std::string figure(const std::string& svg, const std::string& caption, const std::string& kind) {
  return "<figure" + (kind.empty() ? "" : " class=" + kind) + "><figcaption>" + html_text(caption) + "</figcaption>\n" +
         svg + "</figure>\n";
}

std::string status_legend() {
  return "<p>Bar below each plot:<i class=box style='background:#d5d5d5'></i>no hypothesis<i class=box "
         "style='background:#e8c04a'></i>hypotheses, not "
         "called localized<i class=box style='background:#2e9e5b'></i>localized, and right<i class=box "
         "style='background:#d01c1c'></i>localized, and wrong</p>\n";
}

}  // namespace opal::experiments
