//! Who may connect: pages of known origins, with the token.

use std::{cell::RefCell, rc::Rc};
use tungstenite::handshake::server::{Callback, ErrorResponse, Request, Response};

/// Decides on a connection by its request. The decision is kept rather than sent as an HTTP error, since browsers hide such
/// errors from pages: the connection is accepted and closed at once, with the reason.
#[derive(Clone)]
pub struct Gate {
    rules: Rc<GateRules>,
    /// Why the connection is refused.
    refused: Rc<RefCell<Option<&'static str>>>,
}

struct GateRules {
    token: Option<String>,
    origins: Vec<String>,
}

impl Gate {
    pub fn new(token: Option<String>, origins: Vec<String>) -> Self {
        Self { rules: Rc::new(GateRules { token, origins }), refused: Rc::default() }
    }

    /// For another connection.
    pub fn for_next(&self) -> Self {
        Self { rules: Rc::clone(&self.rules), refused: Rc::default() }
    }

    /// Why the connection is refused, once its request was read.
    pub fn refused(&self) -> Option<&'static str> {
        *self.refused.borrow()
    }
}

impl GateRules {
    /// Programs that aren't browsers send no origin.
    fn check(&self, origin: Option<&str>, query: Option<&str>) -> Result<(), &'static str> {
        if !origin.is_none_or(|origin| is_local(origin) || self.origins.iter().any(|known| known == origin)) {
            return Err("pages of this origin aren't accepted: start the bridge with --origin and the page's address");
        }
        let Some(token) = &self.token else { return Ok(()) };
        let given = query.into_iter().flat_map(|query| query.split('&')).find_map(|pair| pair.strip_prefix("token="));
        match given {
            Some(given) if is_same(given, token) => Ok(()),
            Some(_) => Err("the token is wrong: copy the address that the bridge printed"),
            None => Err("this bridge needs a token: copy the address that it printed"),
        }
    }
}

/// A page that was opened from the reader's own computer.
fn is_local(origin: &str) -> bool {
    let host = origin.split_once("://").map(|(_, host)| host).unwrap_or_default();
    let (name, port) =
        host.rsplit_once(':').filter(|(_, port)| port.bytes().all(|b| b.is_ascii_digit())).unwrap_or((host, ""));
    port.len() <= 5 && ["localhost", "127.0.0.1", "[::1]"].contains(&name)
}

/// Compares in a time that doesn't tell where they differ.
fn is_same(given: &str, token: &str) -> bool {
    let differences = given.bytes().zip(token.bytes()).fold(0, |sum, (a, b)| sum | (a ^ b));
    given.len() == token.len() && differences == 0
}

impl Callback for Gate {
    fn on_request(self, request: &Request, response: Response) -> Result<Response, ErrorResponse> {
        let origin = request.headers().get("origin").map(|origin| origin.to_str().unwrap_or("null"));
        *self.refused.borrow_mut() = self.rules.check(origin, request.uri().query()).err();
        Ok(response)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_of_other_origins_are_refused() {
        let rules = GateRules { token: None, origins: vec!["https://example.org".to_owned()] };
        for good in [
            None,
            Some("http://localhost:8080"),
            Some("http://127.0.0.1"),
            Some("https://[::1]:1"),
            Some("https://example.org"),
        ] {
            assert_eq!(rules.check(good, None), Ok(()), "{good:?}");
        }
        for bad in [
            "https://example.com",
            "http://example.org",
            "null",
            "http://localhost.example.com",
            "http://localhost:80.example.com",
            "",
        ] {
            assert!(rules.check(Some(bad), None).is_err(), "{bad}");
        }
    }

    #[test]
    fn the_token_must_be_whole() {
        let rules = GateRules { token: Some("abcd1234".to_owned()), origins: vec![] };
        assert_eq!(rules.check(None, Some("x=1&token=abcd1234")), Ok(()));
        for bad in
            [None, Some(""), Some("token="), Some("token=abcd123"), Some("token=abcd12345"), Some("token=ABCD1234")]
        {
            assert!(rules.check(None, bad).is_err(), "{bad:?}");
        }
        assert!(rules.check(Some("https://evil.example"), Some("token=abcd1234")).is_err());
    }
}
