#include "adapters/web/page_server.hpp"

#include <exception>
#include <utility>

namespace parlour::adapters::web {

namespace {

adapters::http::RequestServerOptions
server_options(const PageServerOptions& options) {
  return {.address = options.address,
          .port = options.port,
          .connections = options.connections,
          .closes_more = true,
          .patience = options.patience};
}

adapters::http::Reply reply_with(int status, Page page) {
  return {.status = status,
          .text = std::move(page.text),
          .content_type = std::move(page.content_type),
          .headers = "Cache-Control: no-store\r\n"};
}

} // namespace

Expected<std::unique_ptr<PageServer>>
PageServer::start(PageServerOptions options, Thrown thrown) {
  const auto place = options.address + " port " + std::to_string(options.port);
  std::unique_ptr<PageServer> pages(new PageServer(std::move(options.pages)));
  auto server = adapters::http::RequestServer::start(
      server_options(options),
      {[self = pages.get()](const auto& request) {
         return self->answer(request);
       },
       [self = pages.get()](int status) { return self->refuse(status); }},
      std::move(thrown));
  if (!server)
    return fail(server.error().kind, "no pages can be served at " + place +
                                         ": " + server.error().message);
  pages->server_ = std::move(*server);
  return pages;
}

// What stands behind a '?' changes nothing.
adapters::http::Reply
PageServer::answer(const adapters::http::ReceivedRequest& request) const {
  const bool is_head = request.method == "HEAD";
  if (!is_head && request.method != "GET") {
    auto refusal = refuse(405);
    refusal.headers += "Allow: GET, HEAD\r\n";
    return refusal;
  }
  const auto page = pages_.find(request.path);
  auto reply = [&] {
    if (page == pages_.end())
      return refuse(404);
    try {
      auto made = page->second();
      const int status = made.is_well ? 200 : 503;
      return reply_with(status, std::move(made));
    } catch (const std::exception& thrown) {
      return reply_with(500, {false, std::string(thrown.what()) + "\n"});
    }
  }();
  reply.without_text = is_head;
  return reply;
}

// The text says which pages there are, as a person may have mistyped one.
adapters::http::Reply PageServer::refuse(int status) const {
  std::string known;
  for (const auto& [path, page] : pages_)
    known += (known.empty() ? "" : ", ") + path;
  return reply_with(status,
                    {false, std::string(adapters::http::words_for(status)) +
                                "; there is: GET " + known + "\n"});
}

} // namespace parlour::adapters::web
