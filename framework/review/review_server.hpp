#pragma once

#include "review/review_page.hpp"

#include <memory>
#include <string>
#include <vector>

namespace opal {

/// Serves the page of a review and takes its decisions: `GET /?key=TOKEN` is the page, `POST /decisions` a document of
/// decisions (decisions.hpp) with the header `X-Opal-Token`. Each time, both files are written before the answer goes
/// out.
///
/// It listens on 127.0.0.1, refuses requests that name another host or come from another origin, and shows the page to
/// those only who know the address that the program printed: other people use this machine, too.
class ReviewServer {
 public:
  static constexpr int kUsualPort = 8715;
  static constexpr std::size_t kLargestPost = 4 << 20;  ///< bytes; more are refused

  /// Serves at once, from threads of its own.
  /// @param review  must outlive it, and must not be touched while it runs. @param notes  above the page.
  /// @param port  0: any free one. @throws Error if it cannot be listened on.
  ReviewServer(Review& review, std::vector<std::string> notes, ReviewFiles files, int port = kUsualPort);
  ~ReviewServer();
  ReviewServer(const ReviewServer&) = delete;
  ReviewServer& operator=(const ReviewServer&) = delete;

  int port() const;
  std::string url() const;  ///< "http://127.0.0.1:8715/?key=TOKEN"

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opal
