use super::parser;
use crate::syntax::{Punct, Tok};

fn vectors(text: &str, count: usize, components: usize) -> (Vec<[f64; 5]>, Tok) {
    let mut p = parser(text);
    let mut all = Vec::new();
    p.vector_list(count, components, &mut |v| all.push(v)).unwrap();
    (all, p.peek().unwrap().tok)
}

#[test]
fn plain_and_other_vectors_mix() {
    let text = "#declare K=5; <1,2,3>, <4,-5,6>/* c */<K,K*2,0>,<7,8,9>, 3*x <1,1>, <10,11,12> #declare L=1; <L,2,3>}";
    let (all, after) = vectors(text, 8, 3);
    let expected = [
        [1.0, 2.0, 3.0],
        [4.0, -5.0, 6.0],
        [5.0, 10.0, 0.0],
        [7.0, 8.0, 9.0],
        [3.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [10.0, 11.0, 12.0],
        [1.0, 2.0, 3.0],
    ];
    assert_eq!(all.iter().map(|v| [v[0], v[1], v[2]]).collect::<Vec<_>>(), expected);
    assert_eq!(after, Tok::Punct(Punct::RightBrace));
}

#[test]
fn a_vector_may_be_part_of_a_longer_expression() {
    let (all, _) = vectors("<1,2,3>*2, <1,2,3>+x <4,5,6> .5", 3, 3);
    assert_eq!(all.iter().map(|v| v[0]).collect::<Vec<_>>(), [2.0, 2.0, 4.0]);
}

#[test]
fn lists_longer_than_a_batch_are_whole() {
    let text: String = (0..1000).map(|i| format!("<{i},{i}.5>, ")).collect();
    let (all, after) = vectors(&format!("{text};"), 1000, 2);
    assert!(all.iter().enumerate().all(|(i, v)| v[0] == i as f64 && v[1] == i as f64 + 0.5));
    assert_eq!(after, Tok::Punct(Punct::Semicolon));
    // The same in kept text.
    let mut p = parser(&format!("#macro M() {text} #end M();"));
    let mut n = 0;
    p.vector_list(1000, 2, &mut |_| n += 1).unwrap();
    assert_eq!((n, p.peek().unwrap().tok), (1000, Tok::Punct(Punct::Semicolon)));
}

#[test]
fn faces_carry_their_texture_numbers() {
    let mut p = parser("#declare T=4; <0,1,2>,<3,4,5>,1,<6,7,8>,1,2,3,<1,2,3> T,<1,2,3>,1+1, 5 /* */}");
    let mut all = Vec::new();
    p.numbered_vector_list(5, 3, &mut |v, n| all.push((v[0], n.to_vec()))).unwrap();
    let expected: [(f64, Vec<f64>); 5] = [
        (0.0, vec![]),
        (3.0, vec![1.0]),
        (6.0, vec![1.0, 2.0, 3.0]),
        (1.0, vec![4.0]),
        (1.0, vec![2.0, 5.0]),
    ];
    assert_eq!(all, expected);
    assert_eq!(p.peek().unwrap().tok, Tok::Punct(Punct::RightBrace));
}
