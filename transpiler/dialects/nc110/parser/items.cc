// What surrounds statements: MSG declarations and comments.
#include "transpiler/dialects/nc110/parser/internal.h"

namespace plcxx::nc110 {

constexpr uint32_t kMaxMessage = 255;
constexpr size_t kMaxMessageText = 42;

void Parser::ParseMessage(Item& item) {
  const Token& word = Take();
  CheckCase(word);
  Message message;
  if (!At(TokenKind::kNumber) || Peek().first_on_line) {
    // A declaration ends with its line.
    Fault(Peek().first_on_line ? BehindPrevious() : MissingAt(), diag::Nc110MsgNumberMissing, Found());
  } else {
    const ConstantUse number = TakeConstant();
    if (number.well_formed && (number.value < 1 || number.value > kMaxMessage)) {
      Fault(number.range, diag::Nc110MsgNumberRange, number.text);
    } else if (number.well_formed) {
      message.number = static_cast<uint16_t>(number.value);
      const MessageId first = messages_by_number_[message.number];
      if (first.valid()) {
        Fault(number.range, diag::Nc110MsgTwice, static_cast<diag::Number>(message.number))
            .notes.push_back({program_.messages[first].text, "the first declaration"});
        message.number = 0;
      }
    }
    if (At(TokenKind::kAssign) && !Peek().first_on_line) {
      Take();
    }
  }
  if (At(TokenKind::kMsgText)) {
    const Token& text = Take();
    message.text = text.range;
    if (TextOf(text).starts_with('"') && !text.faulty) {
      message.text = {text.range.begin + 1, text.range.end - 1};
    }
  }
  const size_t length = CountCodePoints(Plain(message.text));
  if (length == 0) {
    Fault(BehindPrevious(), diag::Nc110MsgTextMissing);
  } else if (length > kMaxMessageText) {
    Fault(message.text, diag::Nc110MsgTextTooLong, static_cast<diag::Number>(length));
  }
  Warn(word.range, diag::Nc110MsgLegacy);
  item.kind = ItemKind::kMessage;
  const MessageId id = program_.messages.Add(message);
  item.detail = id.index;
  if (message.number != 0) {
    messages_by_number_[message.number] = id;
  }
}

void Parser::AttachComments(Item& item, source::Offset next_token) {
  item.first_comment = static_cast<uint32_t>(program_.comments.size());
  for (; next_comment_ < lexed_.comments.size(); ++next_comment_) {
    Comment comment = lexed_.comments[next_comment_];
    if (comment.range.begin < item.range.begin) {
      comment.place = CommentPlace::kLeading;
    } else if (comment.range.begin < item.range.end) {
      comment.place = CommentPlace::kInside;
    } else if (comment.place != CommentPlace::kTrailing || comment.range.begin >= next_token) {
      break;
    }
    program_.comments.push_back(comment);
  }
  item.comment_count = static_cast<uint32_t>(program_.comments.size()) - item.first_comment;
}

/// The first group of comments belongs to the file if a blank line separates it from what follows.
void Parser::SplitOffHeader(SourceFile& file) {
  file.header.first = static_cast<uint32_t>(program_.comments.size());
  const Token& first = lexed_.tokens.front();
  size_t count = 0;
  while (count < lexed_.comments.size() && lexed_.comments[count].range.begin < first.range.begin &&
         (count == 0 || !lexed_.comments[count].blank_line_before)) {
    ++count;
  }
  if (count == 0) {
    return;
  }
  const bool more_comments = count < lexed_.comments.size() && lexed_.comments[count].range.begin < first.range.begin;
  const uint32_t last_line = sources_.Locate(lexed_.comments[count - 1].range.begin).line;
  if (!more_comments && sources_.Locate(first.range.begin).line < last_line + 2) {
    return;
  }
  for (; next_comment_ < count; ++next_comment_) {
    program_.comments.push_back(lexed_.comments[next_comment_]);
    program_.comments.back().place = CommentPlace::kHeader;
  }
  file.header.count = static_cast<uint32_t>(count);
}

}  // namespace plcxx::nc110
